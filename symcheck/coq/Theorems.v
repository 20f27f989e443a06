(* The theorems that the checker takes for granted (symcheck/checker/theorems.py), each under exactly its premises.

   A test compares the statements with that table, name by name. Those about angles, which lemmas of Symcheck.v give
   alike, and at the end all of them together, are added when the file is exported. *)

Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
Require Import Symcheck.Symcheck.
Open Scope R_scope.

(* What a polynomial is, in one letter or in a sine and a cosine *)

Inductive polynomial (atom : (R -> R) -> Prop) : (R -> R) -> Prop :=
  | polynomial_constant c : polynomial atom (fun _ => c)
  | polynomial_atom f : atom f -> polynomial atom f
  | polynomial_sum f g : polynomial atom f -> polynomial atom g -> polynomial atom (fun x => f x + g x)
  | polynomial_product f g : polynomial atom f -> polynomial atom g -> polynomial atom (fun x => f x * g x)
  | polynomial_minus f : polynomial atom f -> polynomial atom (fun x => - f x)
  | polynomial_quotient f c : polynomial atom f -> polynomial atom (fun x => f x / c)
  | polynomial_power f n : polynomial atom f -> polynomial atom (fun x => f x ^ n).

Definition polynomial_in_letter : (R -> R) -> Prop := polynomial (fun f => f = fun x => x).
Definition polynomial_in_circle : (R -> R) -> Prop := polynomial (fun f => f = sin \/ f = cos).

Lemma polynomial_derivative (atom : (R -> R) -> Prop) :
  (forall f, atom f -> exists d, polynomial atom d /\ forall x, is_derive f x (d x)) ->
  forall f, polynomial atom f -> exists d, polynomial atom d /\ forall x, is_derive f x (d x).
Proof.
  intros A f P. induction P as [c | f H | f g F [df [PF DF]] G [dg [PG DG]] | f g F [df [PF DF]] G [dg [PG DG]]
    | f F [df [PF DF]] | f c F [df [PF DF]] | f n F [df [PF DF]]].
  - exists (fun _ => 0). split; [apply polynomial_constant |]. intros x. apply @is_derive_const.
  - exact (A f H).
  - exists (fun x => df x + dg x). split; [apply polynomial_sum; assumption |].
    intros x. apply @is_derive_plus; [apply DF | apply DG].
  - exists (fun x => df x * g x + f x * dg x). split.
    { apply polynomial_sum; apply polynomial_product; assumption. }
    intros x. apply (is_derive_mult f g x (df x) (dg x)); [apply DF | apply DG | apply Rmult_comm].
  - exists (fun x => - df x). split; [apply polynomial_minus; assumption |].
    intros x. apply @is_derive_opp, DF.
  - exists (fun x => df x / c). split; [apply polynomial_quotient; assumption |].
    intros x. apply (is_derive_scal_l f x (df x) (/ c)), DF.
  - exists (fun x => INR n * df x * f x ^ pred n). split.
    { apply polynomial_product; [apply polynomial_product; [apply polynomial_constant | assumption] |].
      apply polynomial_power, F. }
    intros x. apply is_derive_pow, DF.
Qed.

Lemma letter_derivative (f : R -> R) :
  polynomial_in_letter f -> exists d, polynomial_in_letter d /\ forall x, is_derive f x (d x).
Proof.
  apply polynomial_derivative. intros g E. rewrite E. exists (fun _ => 1).
  split; [apply polynomial_constant |]. intros x. apply @is_derive_id.
Qed.

Lemma circle_derivative (f : R -> R) :
  polynomial_in_circle f -> exists d, polynomial_in_circle d /\ forall x, is_derive f x (d x).
Proof.
  apply polynomial_derivative. intros g [E | E]; rewrite E.
  - exists cos. split; [apply polynomial_atom; right; reflexivity |]. intros x. apply is_derive_sin.
  - exists (fun x => - sin x). split; [apply polynomial_minus, polynomial_atom; left; reflexivity |].
    intros x. apply is_derive_cos.
Qed.

Lemma circle_turn (f : R -> R) : polynomial_in_circle f -> f 0 = f (2 * PI).
Proof.
  intros P. induction P as [c | f [E | E] | f g F IF G IG | f g F IF G IG | f F IF | f c F IF | f n F IF].
  - reflexivity.
  - rewrite E, sin_2PI, sin_0. reflexivity.
  - rewrite E, cos_2PI, cos_0. reflexivity.
  - rewrite IF, IG. reflexivity.
  - rewrite IF, IG. reflexivity.
  - rewrite IF. reflexivity.
  - rewrite IF. reflexivity.
  - rewrite IF. reflexivity.
Qed.

Ltac is_polynomial :=
  unfold polynomial_in_letter, polynomial_in_circle;
  repeat match goal with
  | |- polynomial _ (fun _ => ?c) => apply (polynomial_constant _ c)
  | |- polynomial _ (fun x => @?f x + @?g x) => apply (polynomial_sum _ f g)
  | |- polynomial _ (fun x => @?f x * @?g x) => apply (polynomial_product _ f g)
  | |- polynomial _ (fun x => - @?f x) => apply (polynomial_minus _ f)
  | |- polynomial _ (fun x => @?f x / ?c) => apply (polynomial_quotient _ f c)
  | |- polynomial _ (fun x => @?f x ^ ?n) => apply (polynomial_power _ f n)
  end;
  apply polynomial_atom; first [reflexivity | left; reflexivity | right; reflexivity].

(* Sums and products from one whole number to another: those from s to t have t - s + 1 members, or none *)

Definition whole (x : R) : Prop := exists n : Z, x = IZR n.

Fixpoint folded (join : R -> R -> R) (first : R) (f : nat -> R) (n : nat) : R :=
  match n with O => first | S k => join (folded join first f k) (f k) end.

Definition many (s t : R) : nat := Z.to_nat (Int_part (t - s) + 1).
Definition sum_between (f : R -> R) (s t : R) : R := folded Rplus 0 (fun k => f (s + INR k)) (many s t).
Definition product_between (f : R -> R) (s t : R) : R := folded Rmult 1 (fun k => f (s + INR k)) (many s t).

Lemma many_whole (s t : R) : whole s -> whole t -> s - 1 <= t -> INR (many s t) = t - s + 1.
Proof.
  intros [m M] [n N] L. unfold many. rewrite M, N, <- minus_IZR.
  assert (I : Int_part (IZR (n - m)) = (n - m)%Z).
  { destruct (base_Int_part (IZR (n - m))) as [A B]. apply le_IZR in A.
    assert (n - m < Int_part (IZR (n - m)) + 1)%Z by (apply lt_IZR; rewrite plus_IZR; lra). lia. }
  rewrite I, INR_IZR_INZ, Z2Nat.id.
  - rewrite plus_IZR, minus_IZR. ring.
  - apply le_IZR. rewrite plus_IZR, minus_IZR. rewrite M, N in L. lra.
Qed.

Lemma telescoped (join : R -> R -> R) (first : R) (f g : R -> R) (s t : R) :
  whole s ->
  whole t ->
  s - 1 <= t ->
  g (s - 1) = first ->
  (forall x : R, x >= s - 1 -> g (x + 1) = join (g x) (f (x + 1))) ->
  folded join first (fun k => f (s + INR k)) (many s t) = g t.
Proof.
  intros A Z L B T.
  assert (P : forall n, folded join first (fun k => f (s + INR k)) n = g (s - 1 + INR n)).
  { induction n as [| n I].
    - simpl. rewrite Rplus_0_r. symmetry. exact B.
    - change (join (folded join first (fun k => f (s + INR k)) n) (f (s + INR n)) = g (s - 1 + INR (S n))).
      rewrite I, S_INR. replace (s - 1 + (INR n + 1)) with (s - 1 + INR n + 1) by ring.
      rewrite T by (pose proof (pos_INR n); lra). do 2 f_equal. ring. }
  rewrite P, (many_whole s t A Z L). f_equal. ring.
Qed.

Lemma combined (f g h : R -> R) (a b s : R) (n : nat) :
  (forall x : R, x >= s -> f x = a * g x + b * h x) ->
  folded Rplus 0 (fun k => f (s + INR k)) n =
  a * folded Rplus 0 (fun k => g (s + INR k)) n + b * folded Rplus 0 (fun k => h (s + INR k)) n.
Proof.
  intros E. induction n as [| n I]; simpl; [ring |]. rewrite I, E by (pose proof (pos_INR n); lra). ring.
Qed.

(* Integrals over the whole line of what has an integral between any two numbers; one that diverges counts as 0 *)

Definition over_line (f : R -> R) (value : R) : Prop :=
  is_RInt_gen f (Rbar_locally m_infty) (Rbar_locally p_infty) value.
Definition converges_over_line (f : R -> R) : Prop := exists value, over_line f value.
Definition integral_over_line (f : R -> R) : R :=
  if ClassicalDedekindReals.sig_not_dec (converges_over_line f)
  then RInt_gen f (Rbar_locally m_infty) (Rbar_locally p_infty) else 0.
Definition diverges_over_line (f : R -> R) : R :=
  if ClassicalDedekindReals.sig_not_dec (converges_over_line f) then 0 else 1.

Lemma shifted_over_line (f g : R -> R) (a value : R) :
  (forall x : R, f x = g (x + a)) -> over_line g value -> over_line f value.
Proof.
  intros E H P N. destruct (H P N) as [Q R [M HM] [K HK] I].
  apply (Filter_prod _ _ _ (fun x => Q (x + a)) (fun x => R (x + a))).
  - exists (M - a). intros x L. apply HM. simpl in *. lra.
  - exists (K - a). intros x L. apply HK. simpl in *. lra.
  - intros x y Qx Ry. destruct (I _ _ Qx Ry) as [z [J Z]]. exists z. split; [| exact Z].
    apply (is_RInt_ext (fun x => scal 1 (g (1 * x + a)))).
    + intros u _. rewrite E. unfold scal. simpl. unfold mult. simpl. rewrite !Rmult_1_l. reflexivity.
    + apply (is_RInt_comp_lin g 1 a x y z). rewrite !Rmult_1_l. exact J.
Qed.

Lemma same_over_line (f g : R -> R) :
  (forall value, over_line f value <-> over_line g value) ->
  integral_over_line f = integral_over_line g /\ diverges_over_line f = diverges_over_line g.
Proof.
  intros S. unfold integral_over_line, diverges_over_line.
  destruct (ClassicalDedekindReals.sig_not_dec (converges_over_line f)) as [F | F];
    destruct (ClassicalDedekindReals.sig_not_dec (converges_over_line g)) as [G | G]; split; try reflexivity.
  - destruct (Classical_Prop.NNPP _ F) as [v V]. pose proof (proj1 (S v) V) as W.
    rewrite (is_RInt_gen_unique f v V), (is_RInt_gen_unique g v W). reflexivity.
  - exfalso. apply F. intros [v V]. apply G. exists v. apply S, V.
  - exfalso. apply F. intros [v V]. apply G. exists v. apply S, V.
  - exfalso. apply G. intros [v V]. apply F. exists v. apply S, V.
  - exfalso. apply G. intros [v V]. apply F. exists v. apply S, V.
Qed.

(* The integral over a full turn: its antiderivative u/r (x - 2 arctan ...) is smooth everywhere *)

Lemma turned (a r n v : R) :
  0 < a ->
  0 < r ->
  0 < v ->
  n ^ 2 = a ^ 2 - r ^ 2 - (v - a) ^ 2 ->
  ((v - a) * / (r + v) + n * (n * / ((r + v) * (r + v)))) * / (1 + n * / (r + v) * (n * / (r + v) * 1))
  = (v - r) / (2 * v).
Proof.
  intros A R V N.
  replace ((v - a) * / (r + v) + n * (n * / ((r + v) * (r + v)))) with (((v - a) * (r + v) + n ^ 2) / (r + v) ^ 2)
    by (field; lra).
  replace (1 + n * / (r + v) * (n * / (r + v) * 1)) with (((r + v) ^ 2 + n ^ 2) / (r + v) ^ 2) by (field; lra).
  replace ((v - a) * (r + v) + n ^ 2) with ((a + r) * (v - r)) by (rewrite N; ring).
  replace ((r + v) ^ 2 + n ^ 2) with (2 * (a + r) * v) by (rewrite N; ring).
  field. repeat split; lra.
Qed.

(* The theorems *)

Theorem theorem_dichotomy :
  forall (t : R),
  t > 0 \/ t <= 0.
Proof. intros t. destruct (Rlt_or_le 0 t); [left | right]; assumption. Qed.

Theorem theorem_root :
  forall (t : R),
  t >= 0 ->
  sqrt t >= 0 /\ sqrt t ^ 2 = t.
Proof. intros t H. split; [apply Rle_ge, sqrt_pos | apply root_of_number, Rge_le, H]. Qed.

Theorem theorem_root_of_product :
  forall (s t : R),
  s >= 0 ->
  t >= 0 ->
  sqrt (s * t) = sqrt s * sqrt t.
Proof. intros s t Hs Ht. apply sqrt_mult; apply Rge_le; assumption. Qed.

Theorem theorem_equal_squares :
  forall (s t : R),
  s >= 0 ->
  t >= 0 ->
  s ^ 2 = t ^ 2 ->
  s = t.
Proof.
  intros s t Hs Ht E. apply Rsqr_inj; [lra | lra |]. unfold Rsqr. simpl in E. rewrite !Rmult_1_r in E. exact E.
Qed.

Theorem theorem_power :
  forall (b u : R),
  b > 0 ->
  Rpower b u > 0.
Proof. intros. apply exp_pos. Qed.

Theorem theorem_power_of_sum :
  forall (b s t : R),
  b > 0 ->
  Rpower b (s + t) = Rpower b s * Rpower b t.
Proof. intros. apply Rpower_plus. Qed.

Theorem theorem_power_of_product :
  forall (s t u : R),
  s > 0 ->
  t > 0 ->
  Rpower (s * t) u = Rpower s u * Rpower t u.
Proof. intros. symmetry. apply Rpower_mult_distr; assumption. Qed.

Theorem theorem_power_of_power :
  forall (b : R) (n : Z) (u : R),
  b > 0 ->
  Rpower (powerRZ b n) u = Rpower b (IZR n * u) /\ Rpower 1 u = 1.
Proof.
  intros b n u H. split.
  - rewrite (powerRZ_Rpower b n H). apply Rpower_mult.
  - unfold Rpower. rewrite ln_1, Rmult_0_r. apply exp_0.
Qed.

Theorem theorem_power_inverse :
  forall (b u t : R),
  b > 0 ->
  u <> 0 ->
  Rpower b u = t ->
  b = Rpower t (1 / u).
Proof.
  intros b u t Hb Hu E. rewrite <- E, Rpower_mult. replace (u * (1 / u)) with 1 by (field; exact Hu).
  symmetry. apply Rpower_1, Hb.
Qed.

Theorem theorem_circle_number :
  PI > 0.
Proof. exact PI_RGT_0. Qed.

Theorem theorem_right_half :
  forall (a : R),
  - (PI / 2) <= a ->
  a <= PI / 2 ->
  cos a >= 0.
Proof. intros a L H. apply Rle_ge, cos_ge_0; lra. Qed.

Theorem theorem_positive_cosine :
  forall (a : R),
  - (PI / 2) < a ->
  a < PI / 2 ->
  cos a > 0.
Proof. intros a L H. apply Rlt_gt, cos_gt_0; lra. Qed.

Theorem theorem_positive_sine :
  forall (a : R),
  0 < a ->
  a < PI ->
  sin a > 0.
Proof. intros a L H. apply Rlt_gt, sin_gt_0; lra. Qed.

Theorem theorem_mean :
  forall (f : R -> R) (c : R) (g : R -> R),
  polynomial_in_circle g ->
  (forall x : R, f x = c + Derive (fun x => g x) x) ->
  RInt (fun x => f x) 0 (2 * PI) / (2 * PI) = c.
Proof.
  intros f c g P E.
  destruct (circle_derivative g P) as [d [Q D]]. destruct (circle_derivative d Q) as [e [_ F]].
  assert (V : forall x, f x = c + d x) by (intros x; rewrite E; f_equal; apply is_derive_unique, D).
  apply (mean_by (f := f) (g := g)).
  - intros x. apply (ex_derive_ext (fun t => c + d t)); [intros t; symmetry; apply V |].
    apply @ex_derive_plus; [apply @ex_derive_const | exists (e x); apply F].
  - intros x. replace (f x - c) with (d x) by (rewrite V; ring). apply D.
  - apply circle_turn, P.
Qed.

Theorem theorem_quarter_turn :
  forall (f : R -> R),
  polynomial_in_circle f ->
  (forall x : R, f (x + PI / 2) = - f x) ->
  exists x : R, f x = 0.
Proof.
  intros f P T. apply (quarter_turn f); [| exact T].
  intros x. destruct (circle_derivative f P) as [d [_ D]]. exists (d x). apply D.
Qed.

Theorem theorem_intermediate_value :
  forall (f : R -> R) (s t : R),
  polynomial_in_letter f ->
  s < t ->
  f s * f t < 0 ->
  exists x : R, s < x /\ x < t /\ f x = 0.
Proof.
  intros f s t P L S. apply (intermediate_value f); [| exact L | exact S].
  intros x. destruct (letter_derivative f P) as [d [_ D]]. exists (d x). apply D.
Qed.

Theorem theorem_constant :
  forall (c s t : R),
  RInt (fun x => c) s t = c * (t - s).
Proof. intros. rewrite RInt_const. unfold scal. simpl. unfold mult. simpl. ring. Qed.

Theorem theorem_power_rule :
  forall (f : R -> R) (s t c : R) (g : R -> R) (u : R),
  polynomial_in_letter g ->
  s <= t ->
  (forall x : R, s <= x /\ x <= t -> g x > 0 /\ f x = Derive (fun x => c * Rpower (g x) u) x) ->
  RInt (fun x => f x) s t = c * Rpower (g t) u - c * Rpower (g s) u.
Proof.
  intros f s t c g u P L H.
  destruct (letter_derivative g P) as [d [Q D]]. destruct (letter_derivative d Q) as [e [_ F]].
  pose (h := fun x => c * Rpower (g x) u).
  pose (r := fun x => c * (u * (d x / g x) * Rpower (g x) u)).
  assert (B : forall x, 0 < g x -> is_derive h x (r x)).
  { intros x O. unfold h, r, Rpower. auto_derive.
    - repeat split; [exists (d x); apply D | exact O].
    - replace (Derive (fun t => g t) x) with (d x) by (symmetry; apply is_derive_unique, D). field. lra. }
  assert (C : forall x, 0 < g x -> continuous r x).
  { intros x O. apply (ex_derive_continuous (V := R_NormedModule)). unfold r, Rpower. auto_derive.
    repeat split; [exists (e x); apply F | exists (d x); apply D | lra | exists (d x); apply D | exact O]. }
  apply is_RInt_unique, (is_RInt_ext r).
  - rewrite Rmin_left, Rmax_right by exact L. intros x [A Z].
    destruct (H x (conj (Rlt_le _ _ A) (Rlt_le _ _ Z))) as [O E]. rewrite E.
    symmetry. apply is_derive_unique, B, O.
  - apply (is_RInt_derive h r); rewrite Rmin_left, Rmax_right by exact L; intros x I; destruct (H x I) as [O _].
    + apply B, O.
    + apply C, O.
Qed.

Theorem theorem_full_turn :
  forall (f : R -> R) (a b c u r s : R),
  a > 0 ->
  a ^ 2 > b ^ 2 + c ^ 2 ->
  r >= 0 ->
  r ^ 2 = a ^ 2 - (b ^ 2 + c ^ 2) ->
  (forall x : R, a + b * cos x + c * sin x > 0 -> f x = u / (a + b * cos x + c * sin x)) ->
  RInt (fun x => f x) s (s + 2 * PI) = 2 * PI * u / r.
Proof.
  intros f a b c u r s A B R0 R2 E.
  assert (Rp : 0 < r) by (destruct R0 as [P | P]; [exact P | exfalso; rewrite P in R2; lra]).
  pose (w := fun x => a + b * cos x + c * sin x).
  assert (C : forall x, sin x ^ 2 + cos x ^ 2 = 1) by (intros x; pose proof (sin2_cos2 x) as T; unfold Rsqr in T; lra).
  assert (W : forall x, 0 < w x).
  { intros x. unfold w. pose (p := b * cos x + c * sin x).
    replace (a + b * cos x + c * sin x) with (a + p) by (unfold p; ring). assert (p ^ 2 <= b ^ 2 + c ^ 2).
    { unfold p. assert (0 <= (b * sin x - c * cos x) ^ 2) by apply pow2_ge_0.
      replace (b ^ 2 + c ^ 2) with ((b ^ 2 + c ^ 2) * (sin x ^ 2 + cos x ^ 2)) by (rewrite C; ring). lra. }
    assert (p ^ 2 < a ^ 2) by lra. destruct (Rlt_or_le (- a) p) as [G | G]; [lra |]. exfalso.
    assert (0 <= (- p - a) * (- p + a)) by (apply Rmult_le_pos; lra). lra. }
  pose (h := fun x => u / r * (x - 2 * atan ((b * sin x - c * cos x) / (r + w x)))).
  assert (D : forall x, is_derive h x (u / w x)).
  { intros x. pose proof (W x) as Wx. unfold h, w in *. auto_derive.
    - lra.
    - set (S := sin x) in *. set (K := cos x) in *. assert (Q : S ^ 2 + K ^ 2 = 1) by apply C.
      replace (b * (1 * K) + - (c * (1 * - S))) with (a + b * K + c * S - a) by ring.
      replace (- (b * (1 * - S) + c * (1 * K))) with (b * S + - (c * K)) by ring.
      rewrite (turned a r) by (try lra; replace (a ^ 2 - r ^ 2) with ((b ^ 2 + c ^ 2) * (S ^ 2 + K ^ 2))
        by (rewrite Q, R2; ring); ring).
      field. split; lra. }
  apply is_RInt_unique, (is_RInt_ext (fun x => u / w x)).
  - intros x _. symmetry. apply E, W.
  - replace (2 * PI * u / r) with (minus (h (s + 2 * PI)) (h s)).
    + apply (is_RInt_derive h (fun x => u / w x)); intros x _; [apply D |].
      apply (ex_derive_continuous (V := R_NormedModule)). pose proof (W x) as P. unfold w in *. auto_derive. lra.
    + unfold h, w, minus, plus, opp. simpl.
      rewrite sin_plus, cos_plus, sin_2PI, cos_2PI, !Rmult_0_r, !Rmult_1_r, Rminus_0_r, Rplus_0_r. field. lra.
Qed.

Theorem theorem_exp_of_log :
  forall (t : R),
  t > 0 ->
  exp (ln t) = t.
Proof. intros. apply exp_ln. lra. Qed.

Theorem theorem_log_of_one :
  ln 1 = 0.
Proof. exact ln_1. Qed.

Theorem theorem_log_of_exp :
  forall (t : R),
  ln (exp t) = t.
Proof. exact ln_exp. Qed.

Theorem theorem_log_of_product :
  forall (s t : R),
  s > 0 ->
  t > 0 ->
  ln (s * t) = ln s + ln t.
Proof. intros. apply ln_mult; lra. Qed.

Theorem theorem_log_of_power :
  forall (t u : R),
  t > 0 ->
  ln (Rpower t u) = u * ln t.
Proof. intros. unfold Rpower. apply ln_exp. Qed.

Theorem theorem_log_of_root :
  forall (t : R),
  t > 0 ->
  2 * ln (sqrt t) = ln t.
Proof.
  intros t H. assert (P : 0 < sqrt t) by (apply sqrt_lt_R0; lra).
  rewrite <- (sqrt_sqrt t) at 2 by lra. rewrite ln_mult by assumption. ring.
Qed.

Theorem theorem_circular_of_arctan :
  forall (t : R),
  sin (atan t) * sqrt (1 + t ^ 2) = t /\ cos (atan t) * sqrt (1 + t ^ 2) = 1.
Proof.
  intros t. assert (P : 0 < sqrt (1 + t ^ 2)) by (apply sqrt_lt_R0; nra).
  rewrite sin_atan, cos_atan. replace (Rsqr t) with (t ^ 2) by (unfold Rsqr; ring). split; field; lra.
Qed.

Theorem theorem_circular_of_arcsin :
  forall (t : R),
  t ^ 2 <= 1 ->
  sin (asin t) = t /\ cos (asin t) = sqrt (1 - t ^ 2).
Proof.
  intros t H. assert (-1 <= t <= 1) by nra. split; [apply sin_asin; assumption |].
  rewrite cos_asin by assumption. f_equal. unfold Rsqr. ring.
Qed.

Theorem theorem_circular_of_arccos :
  forall (t : R),
  t ^ 2 <= 1 ->
  cos (acos t) = t /\ sin (acos t) = sqrt (1 - t ^ 2).
Proof.
  intros t H. assert (-1 <= t <= 1) by nra. split; [apply cos_acos; assumption |].
  rewrite sin_acos by assumption. f_equal. unfold Rsqr. ring.
Qed.

Theorem theorem_telescope :
  forall (f g : R -> R) (s t : R),
  whole s ->
  whole t ->
  s - 1 <= t ->
  g (s - 1) = 0 ->
  (forall x : R, x >= s - 1 -> g (x + 1) = g x + f (x + 1)) ->
  sum_between (fun x => f x) s t = g t.
Proof. exact (telescoped Rplus 0). Qed.

Theorem theorem_telescoping_product :
  forall (f g : R -> R) (s t : R),
  whole s ->
  whole t ->
  s - 1 <= t ->
  g (s - 1) = 1 ->
  (forall x : R, x >= s - 1 -> g (x + 1) = g x * f (x + 1)) ->
  product_between (fun x => f x) s t = g t.
Proof. exact (telescoped Rmult 1). Qed.

Theorem theorem_power_as_exp :
  forall (b u : R),
  b > 0 ->
  Rpower b u = exp (u * ln b).
Proof. intros. reflexivity. Qed.

Theorem theorem_shifted :
  forall (f g : R -> R) (a : R),
  (forall x : R, f x = g (x + a)) ->
  integral_over_line (fun x => f x) = integral_over_line (fun x => g x) /\ diverges_over_line (fun x => f x) = diverges_over_line (fun x => g x).
Proof.
  intros f g a E. apply same_over_line. intros v. split.
  - apply (shifted_over_line g f (- a)). intros x. rewrite E. f_equal. ring.
  - apply (shifted_over_line f g a), E.
Qed.

Theorem theorem_sum_of_sums :
  forall (f g h : R -> R) (a b s t : R),
  whole s ->
  whole t ->
  (forall x : R, x >= s -> f x = a * g x + b * h x) ->
  sum_between (fun x => f x) s t = a * sum_between (fun x => g x) s t + b * sum_between (fun x => h x) s t.
Proof. intros f g h a b s t _ _ E. apply combined, E. Qed.

Theorem theorem_congruence :
  forall (f : R -> R) (s t : R),
  s = t ->
  f s = f t.
Proof. intros f s t E. rewrite E. reflexivity. Qed.

Theorem theorem_congruence_of_two :
  forall (f : R -> R -> R) (s t u v : R),
  s = t ->
  u = v ->
  f s u = f t v.
Proof. intros f s t u v D E. rewrite D, E. reflexivity. Qed.
