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

(* What a Gaussian outweighs: polynomials in a letter and in sines and cosines *)

Definition polynomial_in_waves : (R -> R) -> Prop :=
  polynomial (fun f => f = (fun x => x) \/ exists p, polynomial_in_letter p /\
    (f = (fun x => sin (p x)) \/ f = (fun x => cos (p x)))).

Lemma letter_is_wave (f : R -> R) : polynomial_in_letter f -> polynomial_in_waves f.
Proof.
  intros P. induction P as [c | f E | f g _ F _ G | f g _ F _ G | f _ F | f c _ F | f n _ F].
  - apply polynomial_constant.
  - apply polynomial_atom. left. exact E.
  - apply polynomial_sum; assumption.
  - apply polynomial_product; assumption.
  - apply polynomial_minus, F.
  - apply polynomial_quotient, F.
  - apply polynomial_power, F.
Qed.

Lemma wave_derivative (f : R -> R) :
  polynomial_in_waves f -> exists d, polynomial_in_waves d /\ forall x, is_derive f x (d x).
Proof.
  apply polynomial_derivative. intros g [E | [p [P [E | E]]]]; rewrite E.
  - exists (fun _ => 1). split; [apply polynomial_constant |]. intros x. apply @is_derive_id.
  - destruct (letter_derivative p P) as [d [Q D]]. exists (fun x => d x * cos (p x)). split.
    + apply polynomial_product; [apply letter_is_wave, Q |]. apply polynomial_atom. right. exists p. auto.
    + intros x. apply (is_derive_comp sin p); [apply is_derive_sin | apply D].
  - destruct (letter_derivative p P) as [d [Q D]]. exists (fun x => d x * - sin (p x)). split.
    + apply polynomial_product; [apply letter_is_wave, Q |]. apply polynomial_minus, polynomial_atom. right. exists p. auto.
    + intros x. apply (is_derive_comp cos p); [apply is_derive_cos | apply D].
Qed.

Lemma at_least_one (x : R) (n : nat) : 1 <= (1 + x ^ 2) ^ n.
Proof. apply pow_R1_Rle. pose proof (pow2_ge_0 x). lra. Qed.

Lemma wave_growth (f : R -> R) :
  polynomial_in_waves f -> exists c n, 0 <= c /\ forall x, Rabs (f x) <= c * (1 + x ^ 2) ^ n.
Proof.
  intros P. induction P as [c | f E | f g _ [c [n [C F]]] _ [d [m [D G]]] | f g _ [c [n [C F]]] _ [d [m [D G]]]
    | f _ [c [n [C F]]] | f k _ [c [n [C F]]] | f k _ [c [n [C F]]]].
  - exists (Rabs c), O. split; [apply Rabs_pos |]. intros x. simpl. lra.
  - destruct E as [E | [p [_ [E | E]]]]; rewrite E.
    + exists 1, 1%nat. split; [lra |]. intros x. apply Rabs_le. simpl. pose proof (pow2_ge_0 (x - 1)).
      pose proof (pow2_ge_0 (x + 1)). simpl in *. lra.
    + exists 1, O. split; [lra |]. intros x. simpl. apply Rabs_le. pose proof (SIN_bound (p x)). lra.
    + exists 1, O. split; [lra |]. intros x. simpl. apply Rabs_le. pose proof (COS_bound (p x)). lra.
  - exists (c + d), (n + m)%nat. split; [lra |]. intros x. eapply Rle_trans; [apply Rabs_triang |].
    rewrite pow_add, Rmult_plus_distr_r. pose proof (at_least_one x n). pose proof (at_least_one x m).
    apply Rplus_le_compat.
    + eapply Rle_trans; [apply F |]. apply Rmult_le_compat_l; [exact C |].
      rewrite <- (Rmult_1_r ((1 + x ^ 2) ^ n)) at 1. apply Rmult_le_compat_l; lra.
    + eapply Rle_trans; [apply G |]. apply Rmult_le_compat_l; [exact D |].
      rewrite <- (Rmult_1_l ((1 + x ^ 2) ^ m)) at 1. apply Rmult_le_compat_r; lra.
  - exists (c * d), (n + m)%nat. split; [apply Rmult_le_pos; assumption |]. intros x. rewrite Rabs_mult, pow_add.
    replace (c * d * ((1 + x ^ 2) ^ n * (1 + x ^ 2) ^ m)) with ((c * (1 + x ^ 2) ^ n) * (d * (1 + x ^ 2) ^ m)) by ring.
    apply Rmult_le_compat; [apply Rabs_pos | apply Rabs_pos | apply F | apply G].
  - exists c, n. split; [exact C |]. intros x. rewrite Rabs_Ropp. apply F.
  - exists (c * Rabs (/ k)), n. split; [apply Rmult_le_pos; [exact C | apply Rabs_pos] |]. intros x.
    unfold Rdiv. rewrite Rabs_mult. replace (c * Rabs (/ k) * (1 + x ^ 2) ^ n) with (c * (1 + x ^ 2) ^ n * Rabs (/ k)) by ring.
    apply Rmult_le_compat_r; [apply Rabs_pos | apply F].
  - exists (c ^ k), (n * k)%nat. split; [apply pow_le, C |]. intros x. rewrite <- RPow_abs, pow_mult, <- Rpow_mult_distr.
    apply pow_incr. split; [apply Rabs_pos | apply F].
Qed.

Lemma outweighed (n : nat) : forall k : R, 0 < k -> exists c, 0 < c /\ forall y, 0 <= y -> (1 + y) ^ n * exp (- (k * y)) <= c.
Proof.
  assert (B : forall k y, 0 < k -> 0 <= y -> (1 + y) * exp (- (k * y)) <= 1 + / k).
  { intros k y K Y. rewrite exp_Ropp. pose proof (exp_pos (k * y)) as P. pose proof (exp_ineq1_le (k * y)) as L.
    apply (Rmult_le_reg_r (exp (k * y))); [exact P |]. rewrite Rmult_assoc, Rinv_l by lra.
    pose proof (Rinv_0_lt_compat k K) as I. apply (Rle_trans _ ((1 + / k) * (1 + k * y))).
    - replace ((1 + / k) * (1 + k * y)) with (1 + y + (/ k + k * y)) by (field; lra). pose proof (Rmult_le_pos k y). lra.
    - apply Rmult_le_compat_l; lra. }
  induction n as [| n I]; intros k K.
  - exists 1. split; [lra |]. intros y Y. simpl. rewrite Rmult_1_l, <- exp_0. pose proof (Rmult_le_pos k y).
    destruct (Req_dec (k * y) 0) as [E | E]; [rewrite E, Ropp_0; lra |]. left. apply exp_increasing. lra.
  - destruct (I (k / 2)) as [c [C H]]; [lra |]. exists ((1 + / (k / 2)) * c). split.
    { apply Rmult_lt_0_compat; [| exact C]. pose proof (Rinv_0_lt_compat (k / 2)). lra. }
    intros y Y. replace (exp (- (k * y))) with (exp (- (k / 2 * y)) * exp (- (k / 2 * y))).
    2: { rewrite <- exp_plus. f_equal. field. }
    simpl. replace ((1 + y) * (1 + y) ^ n * (exp (- (k / 2 * y)) * exp (- (k / 2 * y)))) with
      ((1 + y) * exp (- (k / 2 * y)) * ((1 + y) ^ n * exp (- (k / 2 * y)))) by ring.
    pose proof (exp_pos (- (k / 2 * y))). apply Rmult_le_compat.
    + apply Rmult_le_pos; lra.
    + apply Rmult_le_pos; [apply pow_le |]; lra.
    + apply B; lra.
    + apply H, Y.
Qed.

Lemma small (a b : R) (g : R -> R) :
  a > 0 -> polynomial_in_waves g ->
  exists c, 0 < c /\ forall x, Rabs (exp (b * x - a * x ^ 2) * g x) <= c * / (1 + x ^ 2).
Proof.
  intros A P. destruct (wave_growth g P) as [c [n [C G]]]. destruct (outweighed (S n) (a / 2)) as [d [D H]]; [lra |].
  exists ((c + 1) * (exp (b ^ 2 / (2 * a)) * d)). split.
  { apply Rmult_lt_0_compat; [lra |]. apply Rmult_lt_0_compat; [apply exp_pos | exact D]. }
  intros x. pose proof (pow2_ge_0 x) as X. rewrite Rabs_mult, (Rabs_pos_eq (exp _)) by (left; apply exp_pos).
  assert (E : exp (b * x - a * x ^ 2) <= exp (b ^ 2 / (2 * a)) * exp (- (a / 2 * x ^ 2))).
  { rewrite <- exp_plus. pose proof (pow2_ge_0 (a * x - b)) as Q.
    assert (L : b * x - a * x ^ 2 <= b ^ 2 / (2 * a) + - (a / 2 * x ^ 2)).
    { apply (Rmult_le_reg_r (2 * a)); [lra |].
      replace ((b ^ 2 / (2 * a) + - (a / 2 * x ^ 2)) * (2 * a)) with (b ^ 2 - a ^ 2 * x ^ 2) by (field; lra). nra. }
    destruct L as [L | L]; [left; apply exp_increasing, L | rewrite L; lra]. }
  apply (Rmult_le_reg_r (1 + x ^ 2)); [lra |].
  replace ((c + 1) * (exp (b ^ 2 / (2 * a)) * d) * / (1 + x ^ 2) * (1 + x ^ 2)) with
    ((c + 1) * (exp (b ^ 2 / (2 * a)) * d)) by (field; lra).
  apply (Rle_trans _ ((exp (b ^ 2 / (2 * a)) * exp (- (a / 2 * x ^ 2))) * ((c + 1) * (1 + x ^ 2) ^ n) * (1 + x ^ 2))).
  - apply Rmult_le_compat_r; [lra |]. apply Rmult_le_compat; [left; apply exp_pos | apply Rabs_pos | exact E |].
    eapply Rle_trans; [apply G |]. pose proof (at_least_one x n). apply Rmult_le_compat_r; lra.
  - pose proof (H (x ^ 2) X) as U. simpl in U.
    replace (exp (b ^ 2 / (2 * a)) * exp (- (a / 2 * x ^ 2)) * ((c + 1) * (1 + x ^ 2) ^ n) * (1 + x ^ 2)) with
      ((c + 1) * (exp (b ^ 2 / (2 * a)) * ((1 + x ^ 2) * (1 + x ^ 2) ^ n * exp (- (a / 2 * x ^ 2))))) by ring.
    apply Rmult_le_compat_l; [lra |]. apply Rmult_le_compat_l; [left; apply exp_pos |]. exact U.
Qed.

Lemma far (c eps x : R) : 0 < c -> 0 < eps -> c / eps < Rabs x -> c * / (1 + x ^ 2) < eps.
Proof.
  intros C E L. pose proof (pow2_ge_0 x) as X. apply (Rmult_lt_reg_r (1 + x ^ 2)); [lra |].
  rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. apply (Rmult_lt_compat_r eps) in L; [| exact E].
  replace (c / eps * eps) with c in L by (field; lra). apply (Rlt_le_trans _ _ _ L). rewrite Rmult_comm.
  apply Rmult_le_compat_l; [lra |]. unfold Rabs. destruct (Rcase_abs x); pose proof (pow2_ge_0 (x - 1));
    pose proof (pow2_ge_0 (x + 1)); simpl in *; lra.
Qed.

Lemma vanishes_at_plus (f : R -> R) (c : R) :
  0 < c -> (forall x, Rabs (f x) <= c * / (1 + x ^ 2)) -> filterlim f (Rbar_locally p_infty) (locally 0).
Proof.
  intros C H. apply filterlim_locally. intros eps. exists (c / eps). intros x L.
  change (Rabs (f x - 0) < eps). rewrite Rminus_0_r. eapply Rle_lt_trans; [apply H |]. apply far; [exact C | apply eps |].
  eapply Rlt_le_trans; [exact L | apply Rle_abs].
Qed.

Lemma vanishes_at_minus (f : R -> R) (c : R) :
  0 < c -> (forall x, Rabs (f x) <= c * / (1 + x ^ 2)) -> filterlim f (Rbar_locally m_infty) (locally 0).
Proof.
  intros C H. apply filterlim_locally. intros eps. exists (- (c / eps)). intros x L.
  change (Rabs (f x - 0) < eps). rewrite Rminus_0_r. eapply Rle_lt_trans; [apply H |]. apply far; [exact C | apply eps |].
  rewrite <- Rabs_Ropp. eapply Rlt_le_trans; [| apply Rle_abs]. lra.
Qed.

Lemma by_ends (f : R -> R) (i : R -> R -> R) (value : R) :
  (forall x y, is_RInt f x y (i x y)) ->
  filterlim (fun xy => i (fst xy) (snd xy)) (filter_prod (Rbar_locally m_infty) (Rbar_locally p_infty)) (locally value) ->
  over_line f value.
Proof.
  intros I L P N. apply L in N. unfold filtermapi. unfold filtermap in N. revert N. apply filter_imp.
  intros [x y] H. exists (i x y). split; [apply I | exact H].
Qed.

Lemma primitive_over_line (g d : R -> R) (m p : R) :
  (forall x, is_derive g x (d x)) -> (forall x, continuous d x) ->
  filterlim g (Rbar_locally m_infty) (locally m) -> filterlim g (Rbar_locally p_infty) (locally p) ->
  over_line d (p - m).
Proof.
  intros D C M P. apply (by_ends d (fun x y => minus (g y) (g x))).
  - intros x y. apply (is_RInt_derive g d); intros t _; [apply D | apply C].
  - unfold minus. apply (filterlim_comp_2 (F := filter_prod (Rbar_locally m_infty) (Rbar_locally p_infty))
      (G := locally p) (H := locally (opp m))
      (fun xy => g (snd xy)) (fun xy => opp (g (fst xy))) plus).
    + apply (filterlim_comp _ _ _ snd g _ (Rbar_locally p_infty)); [apply filterlim_snd | exact P].
    + apply (filterlim_comp _ _ _ (fun xy => g (fst xy)) opp _ (locally m)); [| apply @filterlim_opp].
      apply (filterlim_comp _ _ _ fst g _ (Rbar_locally m_infty)); [apply filterlim_fst | exact M].
    + apply @filterlim_plus.
Qed.

(* Gauss's integral: the square of the area and an integral with a parameter have opposite derivatives *)

Definition bell (x : R) : R := exp (- x ^ 2).
Definition area (x : R) : R := RInt bell 0 x.
Definition rest (x : R) : R := RInt (fun t => exp (- (x ^ 2 * (1 + t ^ 2))) / (1 + t ^ 2)) 0 1.

Lemma bell_continuous (x : R) : continuous bell x.
Proof. apply (ex_derive_continuous (V := R_NormedModule)). unfold bell. auto_derive. exact I. Qed.

Lemma area_derivative (x : R) : is_derive area x (bell x).
Proof.
  apply (is_derive_RInt bell area 0 x); [| apply bell_continuous].
  apply filter_forall. intros y. apply (RInt_correct bell 0 y), (ex_RInt_continuous bell). intros z _. apply bell_continuous.
Qed.

Lemma one_plus (t : R) : 0 < 1 + t ^ 2.
Proof. pose proof (pow2_ge_0 t). lra. Qed.

Lemma rest_continuous (x t : R) : continuous (fun t => exp (- (x ^ 2 * (1 + t ^ 2))) / (1 + t ^ 2)) t.
Proof. apply (ex_derive_continuous (V := R_NormedModule)). pose proof (one_plus t). auto_derive. simpl in *. lra. Qed.

Lemma rest_slope (x t : R) :
  is_derive (fun u => exp (- (u ^ 2 * (1 + t ^ 2))) / (1 + t ^ 2)) x (- 2 * x * exp (- (x ^ 2 * (1 + t ^ 2)))).
Proof. pose proof (one_plus t). auto_derive; [simpl in *; lra |]. simpl in *. field. lra. Qed.

Lemma rest_derivative (x : R) : is_derive rest x (RInt (fun t => - 2 * x * exp (- (x ^ 2 * (1 + t ^ 2)))) 0 1).
Proof.
  replace (RInt (fun t => - 2 * x * exp (- (x ^ 2 * (1 + t ^ 2)))) 0 1) with
    (RInt (fun t => Derive (fun u => exp (- (u ^ 2 * (1 + t ^ 2))) / (1 + t ^ 2)) x) 0 1).
  2: { apply RInt_ext. intros t _. apply is_derive_unique, rest_slope. }
  apply (is_derive_RInt_param (fun u t => exp (- (u ^ 2 * (1 + t ^ 2))) / (1 + t ^ 2))).
  - apply filter_forall. intros y t _. eexists. apply rest_slope.
  - intros t _. apply (continuity_2d_pt_ext (fun u v => - 2 * u * exp (- (u ^ 2 * (1 + v ^ 2))))).
    { intros u v. symmetry. apply is_derive_unique, rest_slope. }
    apply continuity_2d_pt_mult.
    + apply continuity_2d_pt_mult; [apply continuity_2d_pt_const | apply continuity_2d_pt_id1].
    + apply (continuity_1d_2d_pt_comp exp (fun u v => - (u ^ 2 * (1 + v ^ 2)))).
      * apply derivable_continuous_pt, derivable_pt_exp.
      * apply continuity_2d_pt_opp, continuity_2d_pt_mult.
        -- apply (continuity_2d_pt_ext (fun u v => u * u)); [intros; simpl; ring |].
           apply continuity_2d_pt_mult; apply continuity_2d_pt_id1.
        -- apply (continuity_2d_pt_ext (fun u v => 1 + v * v)); [intros; simpl; ring |].
           apply continuity_2d_pt_plus; [apply continuity_2d_pt_const |].
           apply continuity_2d_pt_mult; apply continuity_2d_pt_id2.
  - apply filter_forall. intros y. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros t _. apply rest_continuous.
Qed.

Lemma area_and_rest (x : R) : 0 < x -> area x ^ 2 + rest x = PI / 4.
Proof.
  intros X. assert (S : forall x, RInt (fun t => - 2 * x * exp (- (x ^ 2 * (1 + t ^ 2)))) 0 1 = - (2 * area x * bell x)).
  { intros y. apply is_RInt_unique.
    replace (- (2 * area y * bell y)) with (scal (- 2 * bell y) (area y)) by (unfold scal; simpl; unfold mult; simpl; ring).
    apply (is_RInt_ext (fun t => scal (- 2 * bell y) (scal y (bell (y * t + 0))))).
    { intros t _. unfold bell, scal. simpl. unfold mult. simpl.
      replace (- (y * (y * 1) * (1 + t * (t * 1)))) with (- (y * (y * 1)) + - ((y * t + 0) * ((y * t + 0) * 1))) by ring.
      rewrite exp_plus. ring. }
    apply @is_RInt_scal, (is_RInt_comp_lin bell y 0 0 1). rewrite Rmult_0_r, Rmult_1_r, !Rplus_0_r.
    apply (RInt_correct bell 0 y), (ex_RInt_continuous (V := R_CompleteNormedModule)). intros z _. apply bell_continuous. }
  assert (D : forall y, is_derive (fun z => area z ^ 2 + rest z) y 0).
  { intros y. replace 0 with (plus (INR 2 * bell y * area y ^ 1) (- (2 * area y * bell y))) by (unfold plus; simpl; ring).
    apply @is_derive_plus; [apply (is_derive_pow area 2), area_derivative | rewrite <- S; apply rest_derivative]. }
  assert (Z : area 0 ^ 2 + rest 0 = PI / 4).
  { unfold area, rest. rewrite RInt_point. unfold zero. simpl.
    rewrite (RInt_ext _ (fun t => / (1 + t ^ 2))).
    2: { intros t _. rewrite Rmult_0_l, Rmult_0_l, Ropp_0, exp_0. unfold Rdiv. rewrite Rmult_1_l. reflexivity. }
    rewrite (is_RInt_unique _ 0 1 (minus (atan 1) (atan 0))).
    - rewrite atan_1, atan_0. unfold minus, plus, opp. simpl. lra.
    - apply (is_RInt_derive atan).
      + intros t _. replace (/ (1 + t ^ 2)) with (/ (1 + t²)) by (unfold Rsqr; f_equal; ring). apply is_derive_atan.
      + intros t _. apply (ex_derive_continuous (V := R_NormedModule)). pose proof (one_plus t). auto_derive. lra. }
  rewrite <- Z. symmetry. apply (eq_is_derive (fun z => area z ^ 2 + rest z)); [intros t _; apply D | exact X].
Qed.

Lemma rest_small (x : R) : 0 <= rest x <= bell x.
Proof.
  assert (E : ex_RInt (fun t => exp (- (x ^ 2 * (1 + t ^ 2))) / (1 + t ^ 2)) 0 1).
  { apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros t _. apply rest_continuous. }
  split.
  - apply RInt_ge_0; [lra | exact E |]. intros t _. left. apply Rdiv_lt_0_compat; [apply exp_pos | apply one_plus].
  - replace (bell x) with (RInt (fun _ => bell x) 0 1) by (rewrite RInt_const; unfold scal; simpl; unfold mult; simpl; ring).
    apply RInt_le; [lra | exact E | apply ex_RInt_const |]. intros t _. pose proof (one_plus t) as P.
    pose proof (pow2_ge_0 t). pose proof (pow2_ge_0 x). apply (Rmult_le_reg_r (1 + t ^ 2)); [exact P |].
    replace (exp (- (x ^ 2 * (1 + t ^ 2))) / (1 + t ^ 2) * (1 + t ^ 2)) with (exp (- (x ^ 2 * (1 + t ^ 2)))) by (field; lra).
    apply (Rle_trans _ (bell x * 1)).
    + unfold bell. rewrite Rmult_1_r. assert (L : - (x ^ 2 * (1 + t ^ 2)) <= - x ^ 2) by (pose proof (Rmult_le_pos (x ^ 2) (t ^ 2)); lra).
      destruct L as [L | L]; [left; apply exp_increasing, L | rewrite L; lra].
    + apply Rmult_le_compat_l; [left; apply exp_pos | lra].
Qed.

Lemma bell_vanishes : filterlim bell (Rbar_locally p_infty) (locally 0).
Proof.
  destruct (small 1 0 (fun _ => 1)) as [c [C H]]; [lra | apply polynomial_constant |].
  apply (vanishes_at_plus bell c C). intros x. eapply Rle_trans; [| apply H]. unfold bell.
  replace (exp (0 * x - 1 * x ^ 2) * 1) with (exp (- x ^ 2)); [lra |]. rewrite Rmult_1_r. f_equal. ring.
Qed.

Lemma area_limit : filterlim area (Rbar_locally p_infty) (locally (sqrt PI / 2)).
Proof.
  replace (sqrt PI / 2) with (sqrt (PI / 4 - 0)).
  2: { rewrite Rminus_0_r, sqrt_div_alt by lra. replace 4 with (2 ^ 2) by ring. rewrite sqrt_pow2 by lra. reflexivity. }
  apply (filterlim_ext_loc (fun x => sqrt (PI / 4 - rest x))).
  - exists 0. intros x L. rewrite <- (area_and_rest x L). replace (area x ^ 2 + rest x - rest x) with (area x ^ 2) by ring.
    apply sqrt_pow2. apply RInt_ge_0; [lra | |].
    + apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros z _. apply bell_continuous.
    + intros t _. left. apply exp_pos.
  - apply (filterlim_comp _ _ _ (fun x => PI / 4 - rest x) sqrt _ (locally (PI / 4 - 0))).
    + apply (filterlim_comp _ _ _ rest (fun y => PI / 4 - y) _ (locally 0)).
      * apply (filterlim_le_le (fun _ => 0) rest bell (Finite 0)).
        -- apply filter_forall. intros x. apply rest_small.
        -- apply filterlim_const.
        -- apply bell_vanishes.
      * apply (continuous_minus (fun _ => PI / 4) (fun y => y) 0); [apply continuous_const | apply continuous_id].
    + apply continuous_sqrt.
Qed.

Lemma bell_area (x y : R) : is_RInt bell x y (area y - area x).
Proof. apply (is_RInt_derive area bell); intros t _; [apply area_derivative | apply bell_continuous]. Qed.

Lemma area_odd (x : R) : area (- x) = - area x.
Proof.
  assert (D : forall y, is_derive (fun z => area (- z) + area z) y 0).
  { intros y. replace 0 with (plus (scal (-1) (bell (- y))) (bell y)).
    - apply @is_derive_plus; [| apply area_derivative]. apply (is_derive_comp area Ropp y (bell (- y)) (-1)).
      + apply area_derivative.
      + auto_derive; [exact I | ring].
    - unfold bell, plus, scal. simpl. unfold mult. simpl. replace (- y * (- y * 1)) with (y * (y * 1)) by ring. ring. }
  assert (Z : area 0 = 0) by (unfold area; rewrite RInt_point; reflexivity).
  assert (E : forall y z, y < z -> area (- y) + area y = area (- z) + area z).
  { intros y z L. apply (eq_is_derive (fun z => area (- z) + area z)); [intros t _; apply D | exact L]. }
  assert (area (- x) + area x = 0); [| lra].
  destruct (Rtotal_order x 0) as [L | [L | L]].
  - rewrite (E x 0 L), Ropp_0, Z. ring.
  - rewrite L, Ropp_0, Z. ring.
  - rewrite <- (E 0 x L), Ropp_0, Z. ring.
Qed.

Lemma area_limit_minus : filterlim area (Rbar_locally m_infty) (locally (- (sqrt PI / 2))).
Proof.
  apply (filterlim_ext (fun x => opp (area (opp x)))).
  { intros x. unfold opp. simpl. rewrite area_odd. ring. }
  apply (filterlim_comp _ _ _ (fun x => area (opp x)) opp _ (locally (sqrt PI / 2))); [| apply @filterlim_opp].
  apply (filterlim_comp _ _ _ opp area _ (Rbar_locally p_infty)); [| apply area_limit].
  apply (filterlim_Rbar_opp m_infty).
Qed.

(* Fourier's integral of a Gaussian, by its derivative in the frequency *)

Section Wave.
  Variables (a v : R).
  Hypothesis A : a > 0.

  Definition wave (u x : R) : R := exp (- (a * x ^ 2)) * cos (u * x + v).
  Definition between (x y u : R) : R := RInt (wave u) x y.
  Definition edge (u x : R) : R := exp (- (a * x ^ 2)) * sin (u * x + v) / (2 * a).

  Lemma wave_continuous (u x : R) : continuous (wave u) x.
  Proof. apply (ex_derive_continuous (V := R_NormedModule)). unfold wave. auto_derive. exact I. Qed.

  Lemma wave_slope (u x : R) : is_derive (fun u => wave u x) u (- (x * (exp (- (a * x ^ 2)) * sin (u * x + v)))).
  Proof. unfold wave. auto_derive; [exact I |]. simpl. ring. Qed.

  Lemma between_derivative (x y u : R) :
    is_derive (between x y) u (edge u y - edge u x - u / (2 * a) * between x y u).
  Proof.
    replace (edge u y - edge u x - u / (2 * a) * between x y u) with
      (RInt (fun t => Derive (fun u => wave u t) u) x y).
    - apply (is_derive_RInt_param wave x y u).
      + apply filter_forall. intros w t _. eexists. apply wave_slope.
      + intros t _. apply (continuity_2d_pt_ext (fun u x => - (x * (exp (- (a * x ^ 2)) * sin (u * x + v))))).
        { intros w z. symmetry. apply is_derive_unique, wave_slope. }
        apply continuity_2d_pt_opp, continuity_2d_pt_mult; [apply continuity_2d_pt_id2 |]. apply continuity_2d_pt_mult.
        * apply (continuity_1d_2d_pt_comp (fun z => exp (- (a * z ^ 2))) (fun u x => x)); [| apply continuity_2d_pt_id2].
          apply derivable_continuous_pt, ex_derive_Reals_0. auto_derive. exact I.
        * apply (continuity_1d_2d_pt_comp sin (fun u x => u * x + v)).
          -- apply derivable_continuous_pt, derivable_pt_sin.
          -- apply continuity_2d_pt_plus; [| apply continuity_2d_pt_const].
             apply continuity_2d_pt_mult; [apply continuity_2d_pt_id1 | apply continuity_2d_pt_id2].
      + apply filter_forall. intros w. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros t _. apply wave_continuous.
    - apply is_RInt_unique.
      apply (is_RInt_ext (fun t => minus (u / (2 * a) * wave u t - t * (exp (- (a * t ^ 2)) * sin (u * t + v))) (scal (u / (2 * a)) (wave u t)))).
      + intros t _. transitivity (- (t * (exp (- (a * t ^ 2)) * sin (u * t + v)))); [| symmetry; apply is_derive_unique, wave_slope].
        unfold minus, plus, opp, scal. simpl. unfold mult. simpl. ring.
      + apply (is_RInt_minus (fun t => u / (2 * a) * wave u t - t * (exp (- (a * t ^ 2)) * sin (u * t + v))) (fun t => scal (u / (2 * a)) (wave u t)) x y (edge u y - edge u x)).
        * apply (is_RInt_derive (edge u)).
          -- intros t _. unfold edge, wave. auto_derive; [exact I |]. simpl. field. lra.
          -- intros t _. apply (ex_derive_continuous (V := R_NormedModule)). unfold wave. auto_derive. exact I.
        * apply @is_RInt_scal, (RInt_correct (wave u) x y).
          apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros t _. apply wave_continuous.
  Qed.

  Lemma edge_small (u x : R) : Rabs (edge u x) <= exp (- (a * x ^ 2)) / (2 * a).
  Proof.
    unfold edge, Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; lra).
    apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra |].
    rewrite Rabs_mult, (Rabs_pos_eq (exp _)) by (left; apply exp_pos). rewrite <- (Rmult_1_r (exp _)) at 2.
    apply Rmult_le_compat_l; [left; apply exp_pos |]. apply Rabs_le. pose proof (SIN_bound (u * x + v)). lra.
  Qed.

  Lemma between_near (x y u : R) :
    Rabs (exp (u ^ 2 / (4 * a)) * between x y u - between x y 0) <=
    Rabs u * exp (u ^ 2 / (4 * a)) * (exp (- (a * y ^ 2)) / (2 * a) + exp (- (a * x ^ 2)) / (2 * a)).
  Proof.
    pose (h := fun w => exp (w ^ 2 / (4 * a)) * between x y w).
    assert (D : forall w : R, is_derive h w (exp (w ^ 2 / (4 * a)) * (edge w y - edge w x))).
    { intros w. unfold h. replace (exp (w ^ 2 / (4 * a)) * (edge w y - edge w x)) with
        (w / (2 * a) * exp (w ^ 2 / (4 * a)) * between x y w + exp (w ^ 2 / (4 * a)) * (edge w y - edge w x - w / (2 * a) * between x y w)) by ring.
      assert (G : is_derive (fun w => exp (w ^ 2 / (4 * a))) w (w / (2 * a) * exp (w ^ 2 / (4 * a)))).
      { auto_derive; [exact I |]. match goal with |- ?l = ?r => change (@eq R l r) end. simpl. replace (1 * ((1 + 1) * (w * 1)) * / (4 * a)) with (w / (2 * a)) by (field; lra). reflexivity. }
      apply (is_derive_mult (fun w => exp (w ^ 2 / (4 * a))) (between x y) w _ _ G); [apply between_derivative | apply Rmult_comm]. }
    destruct (MVT_gen h 0 u (fun w => exp (w ^ 2 / (4 * a)) * (edge w y - edge w x))) as [w [[L U] M]].
    { intros w _. apply D. }
    { intros w _. apply derivable_continuous_pt, ex_derive_Reals_0. eexists. apply D. }
    replace (exp (u ^ 2 / (4 * a)) * between x y u - between x y 0) with (h u - h 0).
    2: { unfold h. replace (0 ^ 2 / (4 * a)) with 0 by (field; lra). rewrite exp_0. ring. }
    rewrite M, Rminus_0_r, !Rabs_mult, (Rabs_pos_eq (exp _)) by (left; apply exp_pos).
    assert (Q : w ^ 2 <= u ^ 2).
    { unfold Rmin, Rmax in *. destruct (Rle_dec 0 u); nra. }
    assert (E : exp (w ^ 2 / (4 * a)) <= exp (u ^ 2 / (4 * a))).
    { assert (L2 : w ^ 2 / (4 * a) <= u ^ 2 / (4 * a)) by (apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra | exact Q]).
      destruct L2 as [L2 | L2]; [left; apply exp_increasing, L2 | rewrite L2; lra]. }
    replace (Rabs u * exp (u ^ 2 / (4 * a)) * (exp (- (a * y ^ 2)) / (2 * a) + exp (- (a * x ^ 2)) / (2 * a))) with
      (exp (u ^ 2 / (4 * a)) * (exp (- (a * y ^ 2)) / (2 * a) + exp (- (a * x ^ 2)) / (2 * a)) * Rabs u) by ring.
    apply Rmult_le_compat_r; [apply Rabs_pos |]. apply Rmult_le_compat; [left; apply exp_pos | apply Rabs_pos | exact E |].
    unfold Rminus. eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. apply Rplus_le_compat; apply edge_small.
  Qed.
End Wave.

Lemma wave_over_line (a u v : R) :
  a > 0 -> over_line (wave a v u) (exp (- (u ^ 2 / (4 * a))) * (cos v * sqrt (PI / a))).
Proof.
  intros A. assert (S : 0 < sqrt a) by (apply sqrt_lt_R0; lra).
  assert (SS : sqrt a * sqrt a = a) by (apply sqrt_sqrt; lra).
  pose (k := exp (- (u ^ 2 / (4 * a)))).
  assert (K : k * exp (u ^ 2 / (4 * a)) = 1) by (unfold k; rewrite <- exp_plus, Rplus_opp_l; apply exp_0).
  pose (c := Rabs u * exp (u ^ 2 / (4 * a)) / (2 * a)).
  pose (fall := fun x => exp (0 * x - a * x ^ 2) * c).
  destruct (small a 0 (fun _ => c)) as [d [D H]]; [exact A | apply polynomial_constant |].
  assert (Z : forall x y, between a v x y 0 = cos v / sqrt a * (area (sqrt a * y) - area (sqrt a * x))).
  { intros x y. apply is_RInt_unique.
    apply (is_RInt_ext (fun t => scal (cos v / sqrt a) (scal (sqrt a) (bell (sqrt a * t + 0))))).
    - intros t _. unfold wave, bell, scal. simpl. unfold mult. simpl. rewrite Rmult_0_l, Rplus_0_l.
      replace (- ((sqrt a * t + 0) * ((sqrt a * t + 0) * 1))) with (- (a * (t * (t * 1)))) by (rewrite <- SS at 1; ring).
      field. lra.
    - apply @is_RInt_scal, (is_RInt_comp_lin bell (sqrt a) 0 x y). rewrite !Rplus_0_r. apply bell_area. }
  apply (by_ends (wave a v u) (fun x y => plus (scal (k * (cos v / sqrt a)) (plus (area (sqrt a * y)) (opp (area (sqrt a * x)))))
    (between a v x y u - k * between a v x y 0))).
  { intros x y. replace (plus _ _) with (between a v x y u).
    - apply (RInt_correct (wave a v u) x y), (ex_RInt_continuous (V := R_CompleteNormedModule)). intros t _. apply wave_continuous.
    - rewrite Z. unfold plus, opp, scal. simpl. unfold mult. simpl. ring. }
  fold k. replace (k * (cos v * sqrt (PI / a))) with (plus (scal (k * (cos v / sqrt a)) (plus (sqrt PI / 2) (opp (- (sqrt PI / 2))))) 0).
  2: { rewrite sqrt_div_alt by lra. unfold plus, opp, scal. simpl. unfold mult. simpl. field. lra. }
  pose (F := filter_prod (Rbar_locally m_infty) (Rbar_locally p_infty)).
  apply (filterlim_comp_2 (F := F) (G := locally (scal (k * (cos v / sqrt a)) (plus (sqrt PI / 2) (opp (- (sqrt PI / 2)))))) (H := locally 0)
    (fun xy => scal (k * (cos v / sqrt a)) (plus (area (sqrt a * snd xy)) (opp (area (sqrt a * fst xy)))))
    (fun xy => between a v (fst xy) (snd xy) u - k * between a v (fst xy) (snd xy) 0) plus).
  - apply (filterlim_comp _ _ _ (fun xy => plus (area (sqrt a * snd xy)) (opp (area (sqrt a * fst xy)))) (scal (k * (cos v / sqrt a))) _
      (locally (plus (sqrt PI / 2) (opp (- (sqrt PI / 2)))))); [| apply @filterlim_scal_r].
    apply (filterlim_comp_2 (F := F) (G := locally (sqrt PI / 2)) (H := locally (opp (- (sqrt PI / 2))))
      (fun xy => area (sqrt a * snd xy)) (fun xy => opp (area (sqrt a * fst xy))) plus).
    + apply (filterlim_comp _ _ _ snd (fun y => area (sqrt a * y)) _ (Rbar_locally p_infty)); [apply filterlim_snd |].
      apply (filterlim_comp _ _ _ (Rmult (sqrt a)) area _ (Rbar_locally p_infty)); [| apply area_limit].
      intros P [M HM]. exists (M / sqrt a). intros x L. apply HM. apply (Rmult_lt_compat_l (sqrt a)) in L; [| exact S].
      replace (sqrt a * (M / sqrt a)) with M in L by (field; lra). exact L.
    + apply (filterlim_comp _ _ _ (fun xy => area (sqrt a * fst xy)) opp _ (locally (- (sqrt PI / 2)))); [| apply @filterlim_opp].
      apply (filterlim_comp _ _ _ fst (fun y => area (sqrt a * y)) _ (Rbar_locally m_infty)); [apply filterlim_fst |].
      apply (filterlim_comp _ _ _ (Rmult (sqrt a)) area _ (Rbar_locally m_infty)); [| apply area_limit_minus].
      intros P [M HM]. exists (M / sqrt a). intros x L. apply HM. apply (Rmult_lt_compat_l (sqrt a)) in L; [| exact S].
      replace (sqrt a * (M / sqrt a)) with M in L by (field; lra). exact L.
    + apply @filterlim_plus.
  - apply filterlim_locally. intros eps.
    assert (E : 0 < eps / 2 / k) by (apply Rdiv_lt_0_compat; [pose proof (cond_pos eps); lra | apply exp_pos]).
    assert (V : filterlim fall (Rbar_locally p_infty) (locally 0)) by exact (vanishes_at_plus fall d D H).
    assert (W : filterlim fall (Rbar_locally m_infty) (locally 0)) by exact (vanishes_at_minus fall d D H).
    pose proof (proj1 (filterlim_locally fall 0) V (mkposreal _ E)) as VE.
    pose proof (proj1 (filterlim_locally fall 0) W (mkposreal _ E)) as WE.
    apply (Filter_prod _ _ _ _ _ WE VE). intros x y X Y. simpl.
    change (Rabs (fall x - 0) < eps / 2 / k) in X. change (Rabs (fall y - 0) < eps / 2 / k) in Y.
    change (Rabs (between a v x y u - k * between a v x y 0 - 0) < eps). rewrite Rminus_0_r in *.
    replace (between a v x y u - k * between a v x y 0) with
      (k * (exp (u ^ 2 / (4 * a)) * between a v x y u - between a v x y 0))
      by (rewrite Rmult_minus_distr_l, <- Rmult_assoc, K; ring).
    rewrite Rabs_mult, (Rabs_pos_eq k) by (left; apply exp_pos).
    apply (Rle_lt_trans _ (k * (fall y + fall x))).
    + apply Rmult_le_compat_l; [left; apply exp_pos |]. eapply Rle_trans; [apply between_near, A |]. right.
      unfold fall, c. replace (0 * y - a * y ^ 2) with (- (a * y ^ 2)) by ring. replace (0 * x - a * x ^ 2) with (- (a * x ^ 2)) by ring.
      field. lra.
    + pose proof (Rle_abs (fall x)). pose proof (Rle_abs (fall y)). assert (P : 0 < k) by apply exp_pos.
      apply (Rlt_le_trans _ (k * (eps / 2 / k + eps / 2 / k))); [apply Rmult_lt_compat_l; lra |]. right. field. lra.
  - apply @filterlim_plus.
Qed.

Lemma converged_over_line (f : R -> R) (value : R) :
  over_line f value -> integral_over_line f = value /\ diverges_over_line f = 0.
Proof.
  intros H. unfold integral_over_line, diverges_over_line.
  destruct (ClassicalDedekindReals.sig_not_dec (converges_over_line f)) as [_ | F].
  - split; [apply is_RInt_gen_unique, H | reflexivity].
  - exfalso. apply F. exists value. exact H.
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

Theorem theorem_gaussian_wave :
  forall (f g : R -> R) (a b c u v : R),
  polynomial_in_waves g ->
  a > 0 ->
  (forall x : R, f x = Derive (fun x => exp (b * x - a * x ^ 2) * g x) x + c * exp (b * x - a * x ^ 2) * cos (u * x + v)) ->
  integral_over_line (fun x => f x) = c * exp ((b ^ 2 - u ^ 2) / (4 * a)) * cos (b * u / (2 * a) + v) * sqrt (PI / a) /\ diverges_over_line (fun x => f x) = 0.
Proof.
  intros f g a b c u v P A E. apply converged_over_line.
  destruct (wave_derivative g P) as [d [Q G]]. destruct (wave_derivative d Q) as [e [_ D]].
  pose (h := fun x => exp (b * x - a * x ^ 2) * g x).
  pose (r := fun x => (b - 2 * a * x) * exp (b * x - a * x ^ 2) * g x + exp (b * x - a * x ^ 2) * d x).
  assert (B : forall x : R, is_derive h x (r x)).
  { intros x. apply (is_derive_mult (fun x => exp (b * x - a * x ^ 2)) g x); [| apply G | apply Rmult_comm].
    auto_derive; [exact I |]. match goal with |- ?l = ?r => change (@eq R l r) end. simpl. replace (b * x + - (a * (x * (x * 1)))) with (b * x - a * (x * (x * 1))) by ring. ring. }
  assert (C : forall x : R, continuous r x).
  { intros x. apply (ex_derive_continuous (V := R_NormedModule)). unfold r. auto_derive.
    repeat split; [exists (d x); apply G | exists (e x); apply D]. }
  destruct (small a b g A P) as [k [K H]].
  pose proof (primitive_over_line h r 0 0 B C (vanishes_at_minus h k K H) (vanishes_at_plus h k K H)) as L.
  pose (m := b / (2 * a)).
  assert (W : over_line (fun x => wave a (u * m + v) u (x - m)) (exp (- (u ^ 2 / (4 * a))) * (cos (u * m + v) * sqrt (PI / a)))).
  { apply (shifted_over_line _ (wave a (u * m + v) u) (- m)); [reflexivity | apply wave_over_line, A]. }
  replace (c * exp ((b ^ 2 - u ^ 2) / (4 * a)) * cos (b * u / (2 * a) + v) * sqrt (PI / a)) with
    (plus (0 - 0) (scal (c * exp (b ^ 2 / (4 * a))) (exp (- (u ^ 2 / (4 * a))) * (cos (u * m + v) * sqrt (PI / a))))).
  2: { replace (u * m + v) with (b * u / (2 * a) + v) by (unfold m; field; lra).
       replace ((b ^ 2 - u ^ 2) / (4 * a)) with (b ^ 2 / (4 * a) + - (u ^ 2 / (4 * a))) by (field; lra).
       rewrite exp_plus. unfold plus, scal. simpl. unfold mult. simpl. ring. }
  apply (is_RInt_gen_ext (fun x => plus (r x) (scal (c * exp (b ^ 2 / (4 * a))) (wave a (u * m + v) u (x - m))))).
  - apply filter_forall. intros xy x _. rewrite E. fold h. change (fun x => exp (b * x - a * x ^ 2) * g x) with h.
    rewrite (is_derive_unique h x (r x) (B x)). unfold plus, scal, wave. simpl. unfold mult. simpl.
    replace (u * (x - m) + (u * m + v)) with (u * x + v) by ring.
    replace (b * x - a * (x * (x * 1))) with (b * (b * 1) / (4 * a) + - (a * ((x - m) * ((x - m) * 1)))) by (unfold m; field; lra).
    rewrite exp_plus. ring.
  - apply (is_RInt_gen_plus (V := R_NormedModule)); [exact L |]. apply (is_RInt_gen_scal (V := R_NormedModule)), W.
Qed.

Theorem theorem_gaussian :
  forall (f g : R -> R) (a b c : R),
  polynomial_in_waves g ->
  a > 0 ->
  (forall x : R, f x = Derive (fun x => exp (b * x - a * x ^ 2) * g x) x + c * exp (b * x - a * x ^ 2)) ->
  integral_over_line (fun x => f x) = c * exp (b ^ 2 / (4 * a)) * sqrt (PI / a) /\ diverges_over_line (fun x => f x) = 0.
Proof.
  intros f g a b c P A E. replace (c * exp (b ^ 2 / (4 * a)) * sqrt (PI / a)) with
    (c * exp ((b ^ 2 - 0 ^ 2) / (4 * a)) * cos (b * 0 / (2 * a) + 0) * sqrt (PI / a)).
  - apply (theorem_gaussian_wave f g a b c 0 0 P A). intros x. rewrite E, Rmult_0_l, Rplus_0_l, cos_0, Rmult_1_r. reflexivity.
  - replace (b * 0 / (2 * a) + 0) with 0 by (field; lra). rewrite cos_0, Rmult_1_r.
    replace (b ^ 2 - 0 ^ 2) with (b ^ 2) by ring. reflexivity.
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
