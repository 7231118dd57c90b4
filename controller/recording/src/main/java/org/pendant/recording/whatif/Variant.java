package org.pendant.recording.whatif;

import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.script.vm.Program;

/**
 * Variant: what shall be different when a run is repeated from a moment on.
 *
 * @param name for people
 * @param speedFraction where the speed slider is, above 0 to 1; empty for as it was
 * @param loadKg what truly hangs on the flange, kg, with the centre of gravity that the program has
 *     declared; empty for as it was
 * @param program that takes the place of the one that ran, from its start on; empty for as it was
 */
public record Variant(
    String name, OptionalDouble speedFraction, OptionalDouble loadKg, Optional<Program> program) {
  /** The heaviest load, kg. */
  public static final double MAX_LOAD_KG = 100;

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is out of its range
   */
  public Variant {
    if (speedFraction.isPresent()) {
      double fraction = speedFraction.getAsDouble();
      if (!(fraction > 0 && fraction <= 1)) {
        throw new IllegalArgumentException("speed is " + fraction + ", must be above 0 to 1");
      }
    }
    if (loadKg.isPresent() && !(loadKg.getAsDouble() >= 0 && loadKg.getAsDouble() <= MAX_LOAD_KG)) {
      throw new IllegalArgumentException(
          "load is " + loadKg.getAsDouble() + " kg, must be 0 to " + MAX_LOAD_KG);
    }
  }

  /** One in which everything is as it was. */
  public static Variant asItWas(String name) {
    return new Variant(name, OptionalDouble.empty(), OptionalDouble.empty(), Optional.empty());
  }

  /** With the speed slider elsewhere. */
  public Variant withSpeed(double fraction) {
    return new Variant(name, OptionalDouble.of(fraction), loadKg, program);
  }

  /** With another load. */
  public Variant withLoad(double kg) {
    return new Variant(name, speedFraction, OptionalDouble.of(kg), program);
  }

  /** With another program. */
  public Variant withProgram(Program other) {
    return new Variant(name, speedFraction, loadKg, Optional.of(other));
  }
}
