package org.pendant.sweep.plan;

/**
 * Parameter of a sweep: one thing that differs between its variants.
 *
 * @param name of its column in tables
 * @param target what it changes
 * @param range the values that it may have
 */
public record SweepParameter(String name, ParameterTarget target, ParameterRange range) {

  /** The value at a share of the range, 0 to 1, 1 itself excluded for listed values. */
  public ParameterValue at(double share) {
    return switch (range) {
      case ParameterRange.Between between -> ParameterValue.of(between.at(share), target.whole());
      case ParameterRange.Listed(var values) ->
          values.get(Math.min(values.size() - 1, (int) (share * values.size())));
    };
  }

  /** How many values a grid has of it. */
  public int gridSize() {
    return switch (range) {
      case ParameterRange.Between between -> between.steps();
      case ParameterRange.Listed(var values) -> values.size();
    };
  }

  /** Value {@code index} of a grid. */
  ParameterValue gridValue(int index) {
    return switch (range) {
      case ParameterRange.Between between ->
          ParameterValue.of(between.at(index / (double) (between.steps() - 1)), target.whole());
      case ParameterRange.Listed(var values) -> values.get(index);
    };
  }
}
