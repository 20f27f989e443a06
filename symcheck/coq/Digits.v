(* Numbers between decimals: pi, roots, sines, cosines and their inverses, step by step through fractions. *)

Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
Require Import Symcheck.Symcheck.
Open Scope R_scope.

Definition within (t low high : R) : Prop := low <= t <= high.

Lemma number_in (t : R) : within t t t.
Proof. split; apply Rle_refl. Qed.

Lemma equal_in {s t l h : R} : s = t -> within t l h -> within s l h.
Proof. intros E. rewrite E. trivial. Qed.

Lemma sum_in {s t a b c d} (l h : R) : within s a b -> within t c d -> l <= a + c -> b + d <= h -> within (s + t) l h.
Proof. unfold within. lra. Qed.

Lemma minus_in {t a b : R} : within t a b -> within (- t) (- b) (- a).
Proof. unfold within. lra. Qed.

Lemma line (a b c d t : R) : a <= t <= b -> d <= c * a -> d <= c * b -> d <= c * t.
Proof. intros T A B. destruct (Rle_or_lt 0 c); nra. Qed.

Lemma product_in {s t a b c d} (l h : R) : within s a b -> within t c d ->
  l <= a * c <= h -> l <= a * d <= h -> l <= b * c <= h -> l <= b * d <= h -> within (s * t) l h.
Proof.
  intros S T [A1 A2] [B1 B2] [C1 C2] [D1 D2]. split.
  - apply (line c d s l t T); rewrite Rmult_comm; [apply (line a b c l s S) | apply (line a b d l s S)]; lra.
  - apply Ropp_le_cancel. rewrite Ropp_mult_distr_l.
    apply (line c d (- s) (- h) t T); rewrite Ropp_mult_distr_l_reverse; apply Ropp_le_contravar.
    + apply Ropp_le_cancel. rewrite <- Ropp_mult_distr_l_reverse, Rmult_comm, <- Ropp_mult_distr_r, Ropp_mult_distr_l.
      apply (line a b (- c) (- h) s S); lra.
    + apply Ropp_le_cancel. rewrite <- Ropp_mult_distr_l_reverse, Rmult_comm, <- Ropp_mult_distr_r, Ropp_mult_distr_l.
      apply (line a b (- d) (- h) s S); lra.
Qed.

Lemma inverse_in {t a b} (l h : R) : within t a b -> 0 < a -> l * b <= 1 -> 1 <= h * a -> 0 <= l -> within (/ t) l h.
Proof.
  intros [A B] P L H Z. assert (T : 0 < t) by lra. split.
  - apply (Rmult_le_reg_r t _ _ T). rewrite Rinv_l by lra. nra.
  - apply (Rmult_le_reg_r t _ _ T). rewrite Rinv_l by lra.
    assert (0 <= h) by nra. nra.
Qed.

Lemma quotient_in {s t a b c d} (l h : R) : within s a b -> within (/ t) c d ->
  l <= a * c <= h -> l <= a * d <= h -> l <= b * c <= h -> l <= b * d <= h -> within (s / t) l h.
Proof. apply product_in. Qed.

Lemma root_in {t a b} (l h : R) : within t a b -> 0 <= l -> 0 <= h -> l * l <= a -> b <= h * h -> within (sqrt t) l h.
Proof.
  intros [A B] L H P Q. assert (0 <= t) by nra. split.
  - rewrite <- (sqrt_square l L). apply sqrt_le_1_alt. lra.
  - rewrite <- (sqrt_square h H). apply sqrt_le_1_alt. lra.
Qed.

(* pi by 2 arctan(1/3) + arctan(1/7) *)

Lemma pi_in : within PI (31415926535 / 10000000000) (31415926536 / 10000000000).
Proof.
  destruct (PI_2_3_7_ineq 5) as [L H].
  unfold PI_2_3_7_tg, Ratan_seq, tg_alt in L, H.
  cbn [sum_f_R0 Nat.mul Nat.add] in L, H.
  
  simpl INR in L, H. simpl pow in L, H. 
  unfold within. split; lra.
Qed.

(* Sine and cosine by their Taylor polynomials *)

Definition sine_below (x : R) : R :=
  x * (1 - x * x / 6 * (1 - x * x / 20 * (1 - x * x / 42 * (1 - x * x / 72 * (1 - x * x / 110 * (1 - x * x / 156 *
    (1 - x * x / 210))))))).
Definition sine_above (x : R) : R :=
  x * (1 - x * x / 6 * (1 - x * x / 20 * (1 - x * x / 42 * (1 - x * x / 72 * (1 - x * x / 110 * (1 - x * x / 156 *
    (1 - x * x / 210 * (1 - x * x / 272)))))))).
Definition cosine_below (x : R) : R :=
  1 - x * x / 2 * (1 - x * x / 12 * (1 - x * x / 30 * (1 - x * x / 56 * (1 - x * x / 90 * (1 - x * x / 132 *
    (1 - x * x / 182)))))).
Definition cosine_above (x : R) : R :=
  1 - x * x / 2 * (1 - x * x / 12 * (1 - x * x / 30 * (1 - x * x / 56 * (1 - x * x / 90 * (1 - x * x / 132 *
    (1 - x * x / 182 * (1 - x * x / 240))))))).

Lemma factorial_step (n : nat) : INR (Factorial.fact (S n)) = (INR n + 1) * INR (Factorial.fact n).
Proof. rewrite fact_simpl, mult_INR, S_INR. reflexivity. Qed.

Ltac taylor :=
  unfold sin_approx, cos_approx, sin_term, cos_term;
  cbn [sum_f_R0 Nat.mul Nat.add];
  rewrite ?factorial_step; simpl INR; simpl pow.

Lemma sine_between (x : R) : 0 <= x -> x <= PI -> sine_below x <= sin x <= sine_above x.
Proof.
  intros L H.
  destruct (sin_bound x 3 L H) as [A B']. revert A B'. taylor. intros A B'.
  unfold sine_below, sine_above. split.
  - eapply Rle_trans; [| exact A]. right. field.
  - eapply Rle_trans; [exact B' |]. right. field.
Qed.

Lemma cosine_between (x : R) : 0 <= x -> x <= PI / 2 -> cosine_below x <= cos x <= cosine_above x.
Proof.
  intros L H. assert (- PI / 2 <= x) by (generalize PI_RGT_0; lra).
  destruct (cos_bound x 3 H0 H) as [A B]. revert A B. taylor. intros A B.
  unfold cosine_below, cosine_above. split.
  - eapply Rle_trans; [| exact A]. right. field.
  - eapply Rle_trans; [exact B |]. right. field.
Qed.

Lemma quarter : 157 / 100 < PI / 2.
Proof. destruct pi_in. lra. Qed.

Lemma sine_in {t a b} (l h : R) : within t a b -> 0 <= a -> b <= 157 / 100 -> l <= sine_below a -> sine_above b <= h ->
  within (sin t) l h.
Proof.
  intros [A B] P Q L H. generalize quarter. intros W.
  destruct (sine_between a) as [La _]; [lra | lra |]. destruct (sine_between b) as [_ Hb]; [lra | lra |]. split.
  - apply (Rle_trans _ (sin a)); [lra |]. apply sin_incr_1; lra.
  - apply (Rle_trans _ (sin b)); [| lra]. apply sin_incr_1; lra.
Qed.

Lemma cosine_in {t a b} (l h : R) : within t a b -> 0 <= a -> b <= 157 / 100 -> l <= cosine_below b ->
  cosine_above a <= h -> within (cos t) l h.
Proof.
  intros [A B] P Q L H. generalize quarter. intros W.
  destruct (cosine_between b) as [Lb _]; [lra | lra |]. destruct (cosine_between a) as [_ Ha]; [lra | lra |]. split.
  - apply (Rle_trans _ (cos b)); [lra |]. apply cos_decr_1; lra.
  - apply (Rle_trans _ (cos a)); [| lra]. apply cos_decr_1; lra.
Qed.

Lemma arctangent_in {t a b} (l h : R) : within t a b -> 0 <= a -> 0 <= l -> l <= 157 / 100 -> 0 <= h -> h <= 157 / 100 ->
  sine_above l <= a * cosine_below l -> b * cosine_above h <= sine_below h -> within (atan t) l h.
Proof.
  intros [A B] P L L' H H' S T. generalize quarter. intros W.
  destruct (sine_between l) as [_ Sl]; [lra | lra |]. destruct (sine_between h) as [Sh _]; [lra | lra |].
  destruct (cosine_between l) as [Cl _]; [lra | lra |]. destruct (cosine_between h) as [_ Ch]; [lra | lra |].
  assert (0 <= cos l) by (apply cos_ge_0; lra). assert (0 <= cos h) by (apply cos_ge_0; lra).
  split.
  - apply (alike_le (alike_tangent (a := l) (t := t) ltac:(lra) ltac:(lra))). nra.
  - apply Rge_le. apply (alike_ge (alike_tangent (a := h) (t := t) ltac:(lra) ltac:(lra))). nra.
Qed.

Lemma arcsine_in {t a b} (l h : R) : within t a b -> 0 <= a -> b <= 1 -> 0 <= l -> l <= 157 / 100 -> 0 <= h ->
  h <= 157 / 100 -> sine_above l <= a -> b <= sine_below h -> within (asin t) l h.
Proof.
  intros [A B] P Q L L' H H' S T. generalize quarter. intros W.
  destruct (sine_between l) as [_ Sl]; [lra | lra |]. destruct (sine_between h) as [Sh _]; [lra | lra |].
  assert (t ^ 2 <= 1) by nra. split.
  - apply (alike_le (alike_sine (a := l) (t := t) ltac:(assumption) ltac:(lra) ltac:(lra))). lra.
  - apply Rge_le. apply (alike_ge (alike_sine (a := h) (t := t) ltac:(assumption) ltac:(lra) ltac:(lra))). lra.
Qed.

Lemma arccosine_in {t a b} (l h : R) : within t a b -> 0 <= a -> b <= 1 -> 0 <= l -> l <= 157 / 100 -> 0 <= h ->
  h <= 157 / 100 -> b <= cosine_below l -> cosine_above h <= a -> within (acos t) l h.
Proof.
  intros [A B] P Q L L' H H' S T. generalize quarter. intros W.
  destruct (cosine_between l) as [Cl _]; [lra | lra |]. destruct (cosine_between h) as [_ Ch]; [lra | lra |].
  assert (t ^ 2 <= 1) by nra. split.
  - apply (alike_le (alike_cosine (a := l) (t := t) ltac:(assumption) ltac:(lra) ltac:(lra))). lra.
  - apply Rge_le. apply (alike_ge (alike_cosine (a := h) (t := t) ltac:(assumption) ltac:(lra) ltac:(lra))). lra.
Qed.

(* Comparisons of fractions *)
Ltac fractions := unfold sine_below, sine_above, cosine_below, cosine_above; try split; clear; lra.
