(* How a certificate becomes a proof: a few lemmas about real numbers, and tactics for what they leave.

   Nothing here has to be read to know what is confirmed: Coq checks it like everything else. *)

Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* Not zero *)

Lemma num_nz (p : positive) : IZR (Zpos p) <> 0.
Proof. apply not_0_IZR. discriminate. Qed.

Lemma one_nz : 1 <> 0.
Proof. exact R1_neq_R0. Qed.

Lemma mul_nz {a b : R} : a <> 0 -> b <> 0 -> a * b <> 0.
Proof. intros Ha Hb. apply Rmult_integral_contrapositive. split; assumption. Qed.

Lemma sub_nz {a b : R} : a <> b -> a - b <> 0.
Proof. intros H E. apply H. apply Rminus_diag_uniq. exact E. Qed.

Lemma pos_nz {a : R} : 0 < a -> a <> 0.
Proof. intros H E. rewrite E in H. exact (Rlt_irrefl 0 H). Qed.

Lemma neg_nz {a : R} : 0 < - a -> a <> 0.
Proof. lra. Qed.

Lemma nz_of {d e : R} (k : R) : d <> 0 -> d = k * e -> e <> 0.
Proof. intros H E Z. apply H. rewrite E, Z. ring. Qed.

Lemma nz_same {d e : R} : d <> 0 -> e = d -> e <> 0.
Proof. intros H E. rewrite E. exact H. Qed.

Lemma nz_over {d b t : R} : d <> 0 -> b <> 0 -> d * b = t -> t <> 0.
Proof. intros Hd Hb E. rewrite <- E. apply mul_nz; assumption. Qed.

Lemma nz_minus {d e : R} : d <> 0 -> e = - d -> e <> 0.
Proof. intros H E. rewrite E. lra. Qed.

(* Signs *)

Lemma num_pos (p : positive) : 0 < IZR (Zpos p).
Proof. apply IZR_lt. reflexivity. Qed.

Lemma lt_pos {a b : R} : a < b -> 0 < b - a.
Proof. lra. Qed.

Lemma le_nn {a b : R} : a <= b -> 0 <= b - a.
Proof. lra. Qed.

Lemma eq_pos {a b : R} : 0 < a -> b = a -> 0 < b.
Proof. intros H E. rewrite E. exact H. Qed.

Lemma eq_nn {a b : R} : 0 <= a -> b = a -> 0 <= b.
Proof. intros H E. rewrite E. exact H. Qed.

Lemma add_pp {a b : R} : 0 < a -> 0 < b -> 0 < a + b. Proof. lra. Qed.
Lemma add_pn {a b : R} : 0 < a -> 0 <= b -> 0 < a + b. Proof. lra. Qed.
Lemma add_np {a b : R} : 0 <= a -> 0 < b -> 0 < a + b. Proof. lra. Qed.
Lemma add_nn {a b : R} : 0 <= a -> 0 <= b -> 0 <= a + b. Proof. lra. Qed.

Lemma mul_pp {a b : R} : 0 < a -> 0 < b -> 0 < a * b. Proof. apply Rmult_lt_0_compat. Qed.
Lemma mul_nn {a b : R} : 0 <= a -> 0 <= b -> 0 <= a * b. Proof. apply Rmult_le_pos. Qed.

Lemma inv_nn {a : R} : 0 <= a -> 0 <= / a.
Proof.
  intros [H | H].
  - apply Rlt_le, Rinv_0_lt_compat, H.
  - rewrite <- H, Rinv_0. apply Rle_refl.
Qed.

Lemma div_pp {a b : R} : 0 < a -> 0 < b -> 0 < a / b. Proof. apply Rdiv_lt_0_compat. Qed.
Lemma div_nn {a b : R} : 0 <= a -> 0 <= b -> 0 <= a / b.
Proof. intros Ha Hb. apply mul_nn; [exact Ha | apply inv_nn, Hb]. Qed.

Lemma nz_pos {a : R} : 0 <= a -> a <> 0 -> 0 < a.
Proof. lra. Qed.

Lemma pow_pp {a : R} (n : nat) : 0 < a -> 0 < a ^ n. Proof. apply pow_lt. Qed.
Lemma pow_nn {a : R} (n : nat) : 0 <= a -> 0 <= a ^ n. Proof. apply pow_le. Qed.
Lemma pow_even (a : R) (n : nat) : Nat.even n = true -> 0 <= a ^ n.
Proof.
  intros H. apply Nat.even_spec in H. destruct H as [k E]. rewrite E, pow_mult. apply pow_le, pow2_ge_0.
Qed.

Lemma vanish_both {a b : R} : 0 <= a -> 0 <= b -> a + b = 0 -> a = 0 /\ b = 0.
Proof. lra. Qed.

(* Linear combinations of facts: c (l - r) = sum q (a - b) with a = b *)

Lemma fact (q : R) {a b : R} : a = b -> q * (a - b) = 0.
Proof. intros E. rewrite E. ring. Qed.

Lemma and_fact {a b : R} : a = 0 -> b = 0 -> a + b = 0.
Proof. lra. Qed.

Lemma no_facts : 0 = 0.
Proof. reflexivity. Qed.

Lemma combine {c e l r : R} : c <> 0 -> e = 0 -> c * (l - r) = e -> l = r.
Proof.
  intros Hc He H. rewrite He in H. apply Rmult_integral in H.
  destruct H as [H | H]; [contradiction | apply Rminus_diag_uniq; exact H].
Qed.

Lemma combine_le {c e f s l : R} : 0 <= f -> c <> 0 -> e = 0 -> c * (l - s - f) = e -> s <= l.
Proof. intros Hf Hc He H. assert (l - s = f) by exact (combine Hc He H). lra. Qed.

Lemma combine_lt {c e f s l : R} : 0 < f -> c <> 0 -> e = 0 -> c * (l - s - f) = e -> s < l.
Proof. intros Hf Hc He H. assert (l - s = f) by exact (combine Hc He H). lra. Qed.

Lemma combine_ge {c e f s l : R} : 0 <= f -> c <> 0 -> e = 0 -> c * (l - s - f) = e -> l >= s.
Proof. intros Hf Hc He H. apply Rle_ge. exact (combine_le Hf Hc He H). Qed.

Lemma combine_false {c e : R} : c <> 0 -> e = 0 -> c = e -> False.
Proof. intros Hc He H. apply Hc. rewrite H. exact He. Qed.

Lemma pow_zero {a : R} (n : nat) : a ^ n = 0 -> a = 0.
Proof. intros H. destruct (Req_dec a 0) as [E | E]; [exact E |]. exfalso. exact (pow_nonzero a n E H). Qed.

Lemma first_zero {a b : R} (n : nat) : a ^ n * b = 0 -> a = 0 \/ b = 0.
Proof. intros H. apply Rmult_integral in H. destruct H as [H | H]; [left; exact (pow_zero n H) | right; exact H]. Qed.

(* Tactics *)

Ltac positive :=
  match goal with
  | |- _ => assumption
  | |- 0 < IZR (Zpos _) => apply num_pos
  | |- 0 <= IZR (Zpos _) => apply Rlt_le, num_pos
  | |- 0 < PI => exact PI_RGT_0
  | |- 0 < exp _ => apply exp_pos
  | |- 0 <= sqrt _ => apply sqrt_pos
  | |- 0 < _ + _ => apply add_pp; positive
  | |- 0 < _ + _ => apply add_pn; positive
  | |- 0 < _ + _ => apply add_np; positive
  | |- 0 <= _ + _ => apply add_nn; positive
  | |- 0 < _ * _ => apply mul_pp; positive
  | |- 0 <= _ * _ => apply mul_nn; positive
  | |- 0 < _ / _ => apply div_pp; positive
  | |- 0 <= _ / _ => apply div_nn; positive
  | |- 0 < _ ^ _ => apply pow_pp; positive
  | |- 0 <= _ ^ _ => apply pow_even; reflexivity
  | |- 0 <= _ ^ _ => apply pow_nn; positive
  | |- 0 <= _ => apply Rlt_le; positive
  end.

Ltac factor_nonzero :=
  match goal with
  | |- _ => assumption
  | |- IZR (Zpos _) <> 0 => apply num_nz
  | |- IZR _ <> 0 => apply not_0_IZR; discriminate
  | |- PI <> 0 => exact PI_neq0
  | |- _ * _ <> 0 => apply mul_nz; factor_nonzero
  | |- _ ^ _ <> 0 => apply pow_nonzero; factor_nonzero
  | |- / _ <> 0 => apply Rinv_neq_0_compat; factor_nonzero
  | |- - _ <> 0 => apply Ropp_neq_0_compat; factor_nonzero
  | N : ?d <> 0 |- ?e <> 0 => apply (nz_same N); ring
  | N : ?d <> 0 |- ?e <> 0 => apply (nz_minus N); ring
  | |- _ <> 0 => apply pos_nz; positive
  end.

Ltac nonzero := repeat match goal with |- _ /\ _ => split end; factor_nonzero.

(* `auto_derive` writes powers as products; what stands inside a function should look as before. *)
Ltac powers :=
  repeat match goal with
  | |- context [?x * (?x * 1)] => change (x * (x * 1)) with (x ^ 2)
  | |- context [?x * ?x ^ ?n] => change (x * x ^ n) with (x ^ (S n))
  | |- context [?x * / ?y] => change (x * / y) with (x / y)
  end.

Ltac conditions :=
  powers;
  repeat match goal with |- _ /\ _ => split | |- True => exact I end;
  try solve [factor_nonzero | positive | lra].

(* Sines, cosines and roots *)

Lemma circle (x : R) : sin x ^ 2 = 1 - cos x ^ 2.
Proof. generalize (sin2_cos2 x). unfold Rsqr. intro H. lra. Qed.

Lemma root_of_number (t : R) : 0 <= t -> sqrt t ^ 2 = t.
Proof. intros H. simpl. rewrite Rmult_1_r. apply sqrt_sqrt, H. Qed.

Lemma root_is {t v : R} : 0 <= t -> 0 <= v -> v * v = t -> sqrt t = v.
Proof. intros Ht Hv E. exact (sqrt_lem_1 t v Ht Hv E). Qed.

Ltac turn := rewrite ?cos_plus, ?sin_plus, ?cos_plus, ?sin_plus, ?cos_neg, ?sin_neg, ?cos_0, ?sin_0; ring.

(* What is taken for granted of angles by the certificates *)

Lemma asin_known_0 : asin 0 = 0. Proof. exact asin_0. Qed.
Lemma asin_known_1 : asin (1 / 2) = PI / 6.
Proof. rewrite <- sin_PI6. apply asin_sin. generalize PI_RGT_0. lra. Qed.
Lemma asin_known_2 : asin (sqrt 2 / 2) = PI / 4.
Proof.
  replace (sqrt 2 / 2) with (sin (PI / 4)).
  - apply asin_sin. generalize PI_RGT_0. lra.
  - rewrite sin_PI4. assert (P : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
    assert (S : sqrt 2 ^ 2 = 2) by (simpl; rewrite Rmult_1_r; apply sqrt_sqrt; lra). field [S]. lra.
Qed.
Lemma asin_known_3 : asin (sqrt 3 / 2) = PI / 3.
Proof. rewrite <- sin_PI3. apply asin_sin. generalize PI_RGT_0. lra. Qed.
Lemma asin_known_4 : asin 1 = PI / 2. Proof. exact asin_1. Qed.

Lemma acos_known_0 : acos 1 = 0. Proof. exact acos_1. Qed.
Lemma acos_known_1 : acos (sqrt 3 / 2) = PI / 6.
Proof. rewrite <- cos_PI6. apply acos_cos. generalize PI_RGT_0. lra. Qed.
Lemma acos_known_2 : acos (sqrt 2 / 2) = PI / 4.
Proof. rewrite acos_asin, asin_known_2; [lra |]. generalize (sqrt_pos 2), (sqrt_sqrt 2). intros. nra. Qed.
Lemma acos_known_3 : acos (1 / 2) = PI / 3.
Proof. rewrite <- cos_PI3. apply acos_cos. generalize PI_RGT_0. lra. Qed.
Lemma acos_known_4 : acos 0 = PI / 2. Proof. exact acos_0. Qed.

Lemma atan_known_0 : atan 0 = 0. Proof. exact atan_0. Qed.
Lemma atan_known_1 : atan (1 / sqrt 3) = PI / 6.
Proof. rewrite <- tan_PI6. apply atan_tan. generalize PI_RGT_0. lra. Qed.
Lemma atan_known_2 : atan 1 = PI / 4. Proof. exact atan_1. Qed.
Lemma atan_known_3 : atan (sqrt 3) = PI / 3.
Proof. rewrite <- tan_PI3. apply atan_tan. generalize PI_RGT_0. lra. Qed.

Lemma atan_below (t : R) : - (PI / 2) < atan t /\ atan t < PI / 2.
Proof. generalize (atan_bound t). lra. Qed.

Lemma asin_below (t : R) : t ^ 2 <= 1 -> - (PI / 2) <= asin t /\ asin t <= PI / 2.
Proof. intros _. generalize (asin_bound t). lra. Qed.

Lemma acos_below (t : R) : t ^ 2 <= 1 -> 0 <= acos t /\ acos t <= PI.
Proof. intros _. generalize (acos_bound t). lra. Qed.

Lemma in_range {t : R} : t ^ 2 <= 1 -> -1 <= t <= 1.
Proof. intros H. split; nra. Qed.

Lemma atan_acute (t : R) : t >= 0 -> 0 <= atan t /\ atan t <= PI / 2.
Proof.
  intros H. split; [| generalize (atan_bound t); lra].
  destruct (Rge_le _ _ H) as [L | E]; [rewrite <- atan_0; apply Rlt_le, atan_increasing, L |].
  rewrite <- E, atan_0. apply Rle_refl.
Qed.

Lemma asin_acute (t : R) : t ^ 2 <= 1 -> t >= 0 -> 0 <= asin t /\ asin t <= PI / 2.
Proof.
  intros R1 H. generalize (asin_bound t). intros B. split; [| lra].
  apply in_range in R1. destruct (Rle_or_lt 0 (asin t)) as [L | L]; [exact L |].
  assert (S : sin (asin t) < sin 0) by (apply sin_increasing_1; lra).
  rewrite sin_asin, sin_0 in S by lra. lra.
Qed.

Lemma acos_acute (t : R) : t ^ 2 <= 1 -> t >= 0 -> 0 <= acos t /\ acos t <= PI / 2.
Proof.
  intros R1 H. generalize (acos_bound t). intros B. split; [lra |].
  apply in_range in R1. destruct (Rle_or_lt (acos t) (PI / 2)) as [L | L]; [exact L |].
  assert (S : cos (acos t) < cos (PI / 2)) by (apply cos_decreasing_1; lra).
  rewrite cos_acos, cos_PI2 in S by lra. lra.
Qed.

(* Of two angles in a range where f grows (or falls) the one with the greater value of f is the greater (the less). *)

Lemma tangent_grows {a t : R} : - (PI / 2) <= a -> a <= PI / 2 -> (a < atan t <-> sin a < t * cos a).
Proof.
  intros L H. generalize (atan_bound t). intros B.
  destruct (Req_dec a (PI / 2)) as [E | N].
  { rewrite E, cos_PI2, sin_PI2. split; lra. }
  destruct (Req_dec a (- (PI / 2))) as [E | M].
  { rewrite E, cos_neg, sin_neg, cos_PI2, sin_PI2. split; lra. }
  assert (C : 0 < cos a) by (apply cos_gt_0; lra).
  assert (Ea : atan (tan a) = a) by (apply atan_tan; lra).
  assert (T : sin a = tan a * cos a) by (unfold tan; field; lra).
  rewrite T. split; intros I.
  - apply Rmult_lt_compat_r; [exact C |]. destruct (Rlt_or_le (tan a) t) as [Q | Q]; [exact Q |].
    exfalso. rewrite <- Ea in I. destruct Q as [Q | Q].
    + apply atan_increasing in Q. lra.
    + rewrite Q in I. lra.
  - rewrite <- Ea. apply atan_increasing. exact (Rmult_lt_reg_r _ _ _ C I).
Qed.

Lemma tangent_same {a t : R} : - (PI / 2) <= a -> a <= PI / 2 -> (a = atan t <-> sin a = t * cos a).
Proof.
  intros L H. generalize (atan_bound t). intros B.
  destruct (Req_dec a (PI / 2)) as [E | N].
  { rewrite E, cos_PI2, sin_PI2. split; lra. }
  destruct (Req_dec a (- (PI / 2))) as [E | M].
  { rewrite E, cos_neg, sin_neg, cos_PI2, sin_PI2. split; lra. }
  assert (C : 0 < cos a) by (apply cos_gt_0; lra).
  split; intros I.
  - rewrite I. rewrite I in C. rewrite <- (tan_atan t) at 2. unfold tan. field. lra.
  - assert (T : tan a = t) by (unfold tan; rewrite I; field; lra).
    rewrite <- T. symmetry. apply atan_tan. lra.
Qed.

Lemma sine_grows {a b : R} : - (PI / 2) <= a -> a <= PI / 2 -> - (PI / 2) <= b -> b <= PI / 2 ->
  (a < b <-> sin a < sin b).
Proof.
  intros; split; intros.
  - apply sin_increasing_1; lra.
  - apply sin_increasing_0; lra.
Qed.

Lemma cosine_falls {a b : R} : 0 <= a -> a <= PI -> 0 <= b -> b <= PI -> (a < b <-> cos b < cos a).
Proof.
  intros; split; intros.
  - apply cos_decreasing_1; lra.
  - apply cos_decreasing_0; lra.
Qed.

(* All six relations follow from < and = *)

Definition alike (a b x y : R) : Prop := (a < b <-> x < y) /\ (a = b <-> x = y).

Lemma alike_tangent {a t : R} : - (PI / 2) <= a -> a <= PI / 2 -> alike a (atan t) (sin a) (t * cos a).
Proof. intros L H. split; [apply tangent_grows | apply tangent_same]; assumption. Qed.

Lemma alike_sine {a t : R} : t ^ 2 <= 1 -> - (PI / 2) <= a -> a <= PI / 2 -> alike a (asin t) (sin a) t.
Proof.
  intros R1 L H. apply in_range in R1. generalize (asin_bound t). intros B.
  assert (S : sin (asin t) = t) by (apply sin_asin; lra).
  split.
  - rewrite <- S at 2. apply sine_grows; lra.
  - split; intros E; [rewrite E; exact S |]. rewrite <- E. symmetry. apply asin_sin. lra.
Qed.

Lemma alike_cosine {a t : R} : t ^ 2 <= 1 -> 0 <= a -> a <= PI -> alike a (acos t) t (cos a).
Proof.
  intros R1 L H. apply in_range in R1. generalize (acos_bound t). intros B.
  assert (S : cos (acos t) = t) by (apply cos_acos; lra).
  split.
  - rewrite <- S at 2. apply cosine_falls; lra.
  - split; intros E; [rewrite E; symmetry; exact S |]. rewrite E. symmetry. apply acos_cos. lra.
Qed.

Lemma alike_lt {a b x y : R} : alike a b x y -> (a < b <-> x < y).
Proof. intros [L _]. exact L. Qed.

Lemma alike_eq {a b x y : R} : alike a b x y -> (a = b <-> x = y).
Proof. intros [_ E]. exact E. Qed.

Lemma alike_le {a b x y : R} : alike a b x y -> (a <= b <-> x <= y).
Proof. intros [L E]. unfold Rle. rewrite L, E. reflexivity. Qed.

Lemma alike_gt {a b x y : R} : alike a b x y -> (a > b <-> x > y).
Proof.
  intros A. generalize (alike_le A). intros [P Q]. split; intros H; apply Rnot_le_gt; intros K.
  - apply Q in K. lra.
  - apply P in K. lra.
Qed.

Lemma alike_ge {a b x y : R} : alike a b x y -> (a >= b <-> x >= y).
Proof.
  intros A. generalize (alike_lt A). intros [P Q]. split; intros H; apply Rnot_lt_ge; intros K.
  - apply Q in K. lra.
  - apply P in K. lra.
Qed.

Lemma alike_ne {a b x y : R} : alike a b x y -> (a <> b <-> x <> y).
Proof. intros [_ E]. rewrite E. reflexivity. Qed.

(* Means over one turn *)

Lemma continuity_of {f : R -> R} : (forall x, ex_derive f x) -> continuity f.
Proof. intros H x. apply continuity_pt_filterlim. exact (ex_derive_continuous (V := R_NormedModule) f x (H x)). Qed.

Lemma mean_by {f g : R -> R} {m : R} :
  (forall x, ex_derive f x) -> (forall x, is_derive g x (f x - m)) -> g 0 = g (2 * PI) ->
  RInt f 0 (2 * PI) / (2 * PI) = m.
Proof.
  intros Cf D E.
  assert (I : is_RInt (fun x => f x - m) 0 (2 * PI) 0).
  { replace 0 with (minus (g (2 * PI)) (g 0)) at 2 by (unfold minus, plus, opp; simpl; rewrite E; ring).
    apply (is_RInt_derive g (fun x => f x - m)).
    - intros x _. apply D.
    - intros x _. apply (continuous_minus f (fun _ => m)).
      + apply ex_derive_continuous, Cf.
      + apply continuous_const. }
  assert (J : is_RInt f 0 (2 * PI) (2 * PI * m)).
  { replace (2 * PI * m) with (plus 0 (scal (2 * PI - 0) m)) by (unfold plus, scal; simpl; unfold mult; simpl; ring).
    apply (is_RInt_ext (fun x => plus (f x - m) m)).
    - intros x _. unfold plus. simpl. ring.
    - apply (is_RInt_plus (fun x => f x - m) (fun _ => m)); [exact I | apply @is_RInt_const]. }
  rewrite (is_RInt_unique _ _ _ _ J). field. exact PI_neq0.
Qed.

(* The second derivative, where what makes the first one exist holds on both sides of the point *)

Lemma locally_positive {c : R -> R} {x : R} : ex_derive c x -> 0 < c x -> locally x (fun t => 0 < c t).
Proof.
  intros D P. apply (ex_derive_continuous (V := R_NormedModule)) in D.
  apply D. exact (open_gt 0 (c x) P).
Qed.

Lemma derive_twice (c g : R -> R) {f : R -> R} {x v : R} :
  ex_derive c x -> 0 < c x -> (forall t, 0 < c t -> Derive f t = g t) -> Derive g x = v -> Derive_n f 2 x = v.
Proof.
  intros D P F G. simpl. rewrite <- G. apply Derive_ext_loc.
  generalize (locally_positive D P). apply filter_imp. exact F.
Qed.

(* A function that changes its sign under a quarter turn is zero somewhere *)

Lemma quarter_turn (f : R -> R) :
  (forall x, ex_derive f x) -> (forall x, f (x + PI / 2) = - f x) -> exists x, f x = 0.
Proof.
  intros D T. assert (P : 0 <= 0 + PI / 2) by (generalize PI_RGT_0; lra).
  destruct (IVT_cor f 0 (0 + PI / 2) (continuity_of D) P) as [z [_ Z]].
  - rewrite T. generalize (Rle_0_sqr (f 0)). unfold Rsqr. lra.
  - exists z. exact Z.
Qed.

Lemma intermediate_value (f : R -> R) {a b : R} :
  (forall x, ex_derive f x) -> a < b -> f a * f b < 0 -> exists x, a < x /\ x < b /\ f x = 0.
Proof.
  intros D L S. destruct (IVT_cor f a b (continuity_of D) (Rlt_le _ _ L) (Rlt_le _ _ S)) as [z [[A B] Z]].
  exists z. assert (z <> a) by (intros E; rewrite <- E, Z in S; lra).
  assert (z <> b) by (intros E; rewrite <- E, Z in S; lra). lra.
Qed.

(* Witnesses: points at which hypotheses hold *)

Lemma angle_of (s c : R) : s ^ 2 + c ^ 2 = 1 -> exists a, sin a = s /\ cos a = c.
Proof.
  intros H. assert (Hc : -1 <= c <= 1) by (split; nra).
  assert (S : sin (acos c) = sqrt (1 - c ^ 2)) by (rewrite sin_acos by exact Hc; unfold Rsqr; f_equal; ring).
  replace (1 - c ^ 2) with (s ^ 2) in S by lra.
  destruct (Rle_or_lt 0 s) as [P | N].
  - exists (acos c). split; [| apply cos_acos, Hc]. rewrite S. apply sqrt_pow2, P.
  - exists (- acos c). rewrite sin_neg, cos_neg. split; [| apply cos_acos, Hc].
    rewrite S. replace (s ^ 2) with ((- s) ^ 2) by ring. rewrite sqrt_pow2; lra.
Qed.

Ltac known_root n :=
  lazymatch goal with
  | _ : sqrt n ^ 2 = n |- _ => fail
  | |- _ => pose proof (root_of_number n ltac:(lra)); assert (0 < sqrt n) by (apply sqrt_lt_R0; lra)
  end.

Ltac roots := repeat match goal with |- context [sqrt (IZR ?n)] => known_root (IZR n) end.

Ltac by_roots :=
  match goal with
  | S : sqrt _ ^ 2 = _, T : sqrt _ ^ 2 = _ |- _ => field [S T]
  | S : sqrt _ ^ 2 = _ |- _ => field [S]
  end; nonzero.

Lemma sine_of_arctangent {t : R} : 0 < t -> 0 < sin (atan t).
Proof.
  intros P. apply sin_gt_0.
  - rewrite <- atan_0. apply atan_increasing, P.
  - generalize (atan_bound t), PI_RGT_0. lra.
Qed.

Ltac pi_and_cosines :=
  generalize PI2_3_2, PI_4; intros;
  repeat match goal with
  | |- context [cos (atan ?t)] =>
    lazymatch goal with
    | _ : 0 < cos (atan t) |- _ => fail
    | |- _ => assert (0 < cos (atan t)) by (generalize (atan_bound t); intro; apply cos_gt_0; lra)
    end
  end;
  repeat match goal with
  | |- context [sin (atan ?t)] =>
    lazymatch goal with
    | _ : 0 < sin (atan t) |- _ => fail
    | |- _ => assert (0 < sin (atan t)) by (apply sine_of_arctangent; positive)
    end
  end.

Ltac concrete := intros; roots; pi_and_cosines; solve [reflexivity | factor_nonzero | apply Rgt_not_eq, cos_gt_0; lra | apply Rgt_not_eq, sin_gt_0; lra | apply cos_gt_0; lra | apply sin_gt_0; lra | apply Rgt_not_eq, sqrt_lt_R0; lra | lra | left; lra | right; lra | nra | field; nonzero | by_roots | field_simplify; nra].
