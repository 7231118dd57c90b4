package org.pendant.sweep.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.hipparchus.optim.InitialGuess;
import org.hipparchus.optim.MaxEval;
import org.hipparchus.optim.SimpleBounds;
import org.hipparchus.optim.SimpleValueChecker;
import org.hipparchus.optim.nonlinear.scalar.GoalType;
import org.hipparchus.optim.nonlinear.scalar.ObjectiveFunction;
import org.hipparchus.optim.nonlinear.scalar.noderiv.CMAESOptimizer;
import org.hipparchus.random.MersenneTwister;
import org.junit.jupiter.api.Test;

final class CmaEsSearchTest {
  private static final int POPULATION = 8;

  /** A narrow valley that is bent, with its lowest point at 0.7, 0.49 (Rosenbrock's function). */
  private static double valley(List<Double> point) {
    double x = point.get(0);
    double y = point.get(1);
    return 100 * Math.pow(y - x * x, 2) + Math.pow(0.7 - x, 2);
  }

  private static List<List<Double>> points(
      CmaEsSearch search, ToDoubleFunction<List<Double>> function, int most) {
    List<List<Double>> points = new ArrayList<>();
    List<Double> values = new ArrayList<>();
    List<List<Double>> next = search.next(values);
    while (!next.isEmpty() && points.size() < most) {
      points.addAll(next);
      next.forEach(each -> values.add(function.applyAsDouble(each)));
      next = search.next(values);
    }
    return points;
  }

  @Test
  void generationsAreTheOnesThatTheOptimizerAsksForOneByOne() {
    List<List<Double>> oneByOne = new ArrayList<>();
    int count = 1 + 20 * POPULATION;
    new CMAESOptimizer(
            CmaEsSearch.MAX_GENERATIONS,
            Double.NEGATIVE_INFINITY,
            true,
            0,
            0,
            new MersenneTwister(5L),
            false,
            new SimpleValueChecker(-1, -1))
        .optimize(
            new MaxEval(count),
            new ObjectiveFunction(
                point -> {
                  List<Double> asked = IntStream.range(0, 2).mapToObj(i -> point[i]).toList();
                  oneByOne.add(asked);
                  return valley(asked);
                }),
            GoalType.MINIMIZE,
            new CMAESOptimizer.PopulationSize(POPULATION),
            new CMAESOptimizer.Sigma(new double[] {0.3, 0.3}),
            new InitialGuess(new double[] {0.5, 0.5}),
            new SimpleBounds(new double[2], new double[] {1, 1}));
    assertEquals(count, oneByOne.size());
    assertEquals(
        oneByOne,
        points(new CmaEsSearch(2, POPULATION, 5), CmaEsSearchTest::valley, count)
            .subList(0, count));
  }

  @Test
  void lowestPointOfABentValleyIsFound() {
    List<List<Double>> points =
        points(new CmaEsSearch(2, POPULATION, 1), CmaEsSearchTest::valley, 1000);
    double least = points.stream().mapToDouble(CmaEsSearchTest::valley).min().orElseThrow();
    assertTrue(least < 1e-8, "least " + least);
    assertTrue(
        points.stream().flatMap(List::stream).allMatch(each -> each >= 0 && each <= 1), "bounds");
  }
}
