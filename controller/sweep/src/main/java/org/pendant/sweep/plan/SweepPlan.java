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
 * @param search what their values are searched for; empty where they are sampled
 */
public record SweepPlan(
    String name,
    String program,
    Optional<String> robot,
    Optional<String> installation,
    Optional<String> scene,
    RunSettings settings,
    Sampling sampling,
    List<SweepParameter> parameters,
    Optional<SearchGoal> search) {
  /** Copies the list. */
  public SweepPlan {
    parameters = List.copyOf(parameters);
  }

  /** How many variants there are; of a search how many at most. */
  public long size() {
    return sampling.runs();
  }

  /**
   * A variant.
   *
   * @param number 0 to the size, excluded
   * @throws IllegalStateException for a search, whose variants follow from results
   */
  public SweepVariant variant(long number) {
    List<ParameterValue> values = new ArrayList<>();
    double[] sobol =
        sampling.method() == SamplingMethod.SOBOL
            ? SobolPoints.point(parameters.size(), number, sampling.seed())
            : new double[0];
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
        case SOBOL -> values.add(each.at(sobol[i]));
        case SEARCH ->
            throw new IllegalStateException("the variants of a search follow from its results");
      }
    }
    return new SweepVariant(number, values);
  }

  /**
   * The variant of a row, by the values in it.
   *
   * @param number of the row
   * @param cells of the parameters, as tables write them
   */
  public SweepVariant variantOfRow(long number, List<String> cells) {
    if (search.isEmpty()) {
      return variant(number);
    }
    List<ParameterValue> values = new ArrayList<>();
    for (int i = 0; i < parameters.size(); i++) {
      values.add(
          ParameterValue.of(Double.parseDouble(cells.get(i)), parameters.get(i).target().whole()));
    }
    return new SweepVariant(number, values);
  }

  private double latin(long number, int parameter) {
    long slice =
        new Shuffle(size(), UnitNumbers.mixed(sampling.seed(), parameter, -1)).place(number);
    return (slice + UnitNumbers.at(sampling.seed(), number, parameter)) / size();
  }
}
