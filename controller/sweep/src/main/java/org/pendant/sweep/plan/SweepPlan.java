package org.pendant.sweep.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Sweep plan: what runs, with which values. docs/sweeps.md describes the file. Immutable; a variant
 * follows from its number alone, so any worker can make any of them.
 *
 * @param name of the file, for messages
 * @param program name of the file with the program, as all names seen from the folder of the plan
 * @param robot name of the arm, or of its file; empty for that of the installation or program
 * @param installation name of its file
 * @param scene name of its file
 * @param settings what is the same for all variants
 * @param sampling which variants there are
 * @param parameters by what they differ, in the order of their columns
 */
public record SweepPlan(
    String name,
    String program,
    Optional<String> robot,
    Optional<String> installation,
    Optional<String> scene,
    RunSettings settings,
    Sampling sampling,
    List<SweepParameter> parameters) {
  /** Copies the list. */
  public SweepPlan {
    parameters = List.copyOf(parameters);
  }

  /** How many variants there are. */
  public long size() {
    return sampling.runs();
  }

  /**
   * A variant.
   *
   * @param number 0 to the size, excluded
   */
  public SweepVariant variant(long number) {
    List<ParameterValue> values = new ArrayList<>();
    long rest = number;
    long below = size();
    for (int i = 0; i < parameters.size(); i++) {
      SweepParameter each = parameters.get(i);
      switch (sampling.method()) {
        case GRID -> {
          below /= each.gridSize();
          values.add(each.gridValue((int) (rest / below)));
          rest %= below;
        }
        case LIST -> values.add(each.gridValue((int) number));
        case RANDOM -> values.add(each.at(UnitNumbers.at(sampling.seed(), number, i)));
        case LATIN_HYPERCUBE -> values.add(each.at(latin(number, i)));
      }
    }
    return new SweepVariant(number, values);
  }

  private double latin(long number, int parameter) {
    long slice =
        new Shuffle(size(), UnitNumbers.mixed(sampling.seed(), parameter, -1)).place(number);
    return (slice + UnitNumbers.at(sampling.seed(), number, parameter)) / size();
  }
}
