package org.pendant.desktop.whatif;

import java.util.Optional;
import org.pendant.recording.whatif.VariantOutcome;
import org.pendant.recording.whatif.VariantRun;

/** Variant result: how far a row of the panel has come. */
sealed interface VariantResult {
  /** It has not run as it is. */
  record None() implements VariantResult {}

  /** Others run first. */
  record Waiting() implements VariantResult {}

  /** It runs. */
  record Running(VariantRun run) implements VariantResult {}

  /** It has run. */
  record Done(VariantOutcome outcome) implements VariantResult {}

  /** It could not run; the reason is for people. */
  record Refused(String reason) implements VariantResult {}

  /** What came of it; empty where nothing has yet. */
  default Optional<VariantOutcome> finished() {
    return this instanceof Done(VariantOutcome outcome) ? Optional.of(outcome) : Optional.empty();
  }

  /** Whether it is still to come. */
  default boolean open() {
    return this instanceof Waiting || this instanceof Running;
  }
}
