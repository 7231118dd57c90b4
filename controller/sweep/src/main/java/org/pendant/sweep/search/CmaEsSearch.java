package org.pendant.sweep.search;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.hipparchus.exception.MathIllegalStateException;
import org.hipparchus.optim.InitialGuess;
import org.hipparchus.optim.MaxEval;
import org.hipparchus.optim.SimpleBounds;
import org.hipparchus.optim.SimpleValueChecker;
import org.hipparchus.optim.nonlinear.scalar.GoalType;
import org.hipparchus.optim.nonlinear.scalar.ObjectiveFunction;
import org.hipparchus.optim.nonlinear.scalar.noderiv.CMAESOptimizer;
import org.hipparchus.random.MersenneTwister;

/**
 * Search by CMA-ES (Hansen, The CMA evolution strategy, 2016), in the cube of shares of the ranges
 * of all parameters. Hipparchus has it, but asks for one value after another, while the points of a
 * generation can run at once. So the optimizer is started anew for each generation and told all
 * values that are known: from the same seed it comes to the same place, and what it asks for then
 * is the next generation. Hence a search goes on from its table alone, and any engine can run it.
 */
final class CmaEsSearch {
  /** Largest step at first, as a share of the range. */
  private static final double SIGMA = 0.3;

  static final int MAX_GENERATIONS = 100_000;

  private final int dimension;
  private final int population;
  private final long seed;

  /** Leaves the optimizer when a generation is complete. */
  private static final class Asked extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private Asked() {
      super("a generation is complete", null, false, false);
    }
  }

  CmaEsSearch(int dimension, int population, long seed) {
    this.dimension = dimension;
    this.population = population;
    this.seed = seed;
  }

  /**
   * The points to run next; none when the optimizer has come to its end. The first generation is
   * one point in the middle.
   *
   * @param values of all points that it has asked for, the smaller the better, in their order
   */
  List<List<Double>> next(List<Double> values) {
    List<List<Double>> asked = new ArrayList<>();
    int wanted = values.isEmpty() ? 1 : population;
    int[] count = {0};
    CMAESOptimizer optimizer =
        new CMAESOptimizer(
            MAX_GENERATIONS,
            Double.NEGATIVE_INFINITY,
            true,
            0,
            0,
            new MersenneTwister(seed),
            false,
            new SimpleValueChecker(-1, -1));
    try {
      optimizer.optimize(
          new MaxEval(Integer.MAX_VALUE),
          new ObjectiveFunction(
              point -> {
                if (count[0] < values.size()) {
                  return values.get(count[0]++);
                }
                asked.add(IntStream.range(0, dimension).mapToObj(i -> point[i]).toList());
                if (asked.size() == wanted) {
                  throw new Asked();
                }
                return 0;
              }),
          GoalType.MINIMIZE,
          new CMAESOptimizer.PopulationSize(population),
          new CMAESOptimizer.Sigma(all(SIGMA)),
          new InitialGuess(all(0.5)),
          new SimpleBounds(all(0), all(1)));
    } catch (Asked complete) {
      return asked;
    } catch (MathIllegalStateException ended) {
      // it has made all its generations
      return List.of();
    }
    return List.of();
  }

  private double[] all(double value) {
    return IntStream.range(0, dimension).mapToDouble(_ -> value).toArray();
  }
}
