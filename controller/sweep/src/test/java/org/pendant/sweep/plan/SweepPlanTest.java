package org.pendant.sweep.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

final class SweepPlanTest {
  private static SweepPlan plan(String sampling, String parameters) throws PlanException {
    return PlanReader.read(
        "p.toml", "program = \"a.script\"\n[sampling]\n" + sampling + parameters);
  }

  private static final String TWO =
      """
      [[parameter]]
      set = "speed"
      from = 0.5
      to = 1.5
      steps = 3
      [[parameter]]
      set = "variable CLOSED"
      values = [true, false]
      """;

  private static List<String> texts(SweepPlan plan) {
    List<String> texts = new ArrayList<>();
    for (long i = 0; i < plan.size(); i++) {
      texts.add(
          String.join(" ", plan.variant(i).values().stream().map(ParameterValue::text).toList()));
    }
    return texts;
  }

  @Test
  void gridHasEveryCombinationAndItsLastParameterChangesFirst() throws PlanException {
    assertEquals(
        List.of("0.5 True", "0.5 False", "1.0 True", "1.0 False", "1.5 True", "1.5 False"),
        texts(plan("method = \"grid\"\n", TWO)));
  }

  @Test
  void listHasTheFirstOfAllThenTheSecondOfAll() throws PlanException {
    assertEquals(
        List.of("1 p[0, 0, 0.1, 0, 0, 0]", "2 None"),
        texts(
            plan(
                "method = \"list\"\n",
                """
                [[parameter]]
                set = "seed"
                values = [1, 2]
                [[parameter]]
                set = "variable place"
                values = ["p[0, 0, 0.1, 0, 0, 0]", "None"]
                """)));
  }

  @Test
  void randomVariantFollowsFromSeedAndNumberAlone() throws PlanException {
    SweepPlan one = plan("method = \"random\"\nruns = 100\nseed = 4\n", TWO);
    SweepPlan more = plan("method = \"random\"\nruns = 1000000\nseed = 4\n", TWO);
    SweepPlan other = plan("method = \"random\"\nruns = 100\nseed = 5\n", TWO);
    assertEquals(one.variant(57), more.variant(57));
    assertNotEquals(one.variant(57), other.variant(57));
    for (long i = 0; i < one.size(); i++) {
      double speed = one.variant(i).values().getFirst().number();
      assertTrue(speed >= 0.5 && speed < 1.5, "speed " + speed);
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 7, 64, 1000})
  void latinHypercubeHasOneValueInEachSliceOfEachParameter(long runs) throws PlanException {
    SweepPlan plan =
        plan(
            String.format(Locale.ROOT, "method = \"latin-hypercube\"%nruns = %d%n", runs),
            """
            [[parameter]]
            set = "speed"
            from = 0
            to = 1
            [[parameter]]
            set = "acceleration"
            from = 0
            to = 1
            """);
    for (int parameter = 0; parameter < 2; parameter++) {
      Set<Long> slices = new TreeSet<>();
      for (long i = 0; i < runs; i++) {
        slices.add((long) (plan.variant(i).values().get(parameter).number() * runs));
      }
      assertEquals(runs, slices.size());
    }
  }

  @Test
  void sobolPointsHaveOneOfEachSliceForEveryPowerOfTwo() throws PlanException {
    SweepPlan plan =
        plan(
            "method = \"sobol\"\nruns = 64\n",
            """
            [[parameter]]
            set = "speed"
            from = 0
            to = 1
            [[parameter]]
            set = "acceleration"
            from = 0
            to = 1
            """);
    for (int parameter = 0; parameter < 2; parameter++) {
      Set<Long> slices = new TreeSet<>();
      for (long i = 0; i < 64; i++) {
        slices.add((long) (plan.variant(i).values().get(parameter).number() * 64));
      }
      assertEquals(64, slices.size());
    }
    assertEquals(plan.variant(17), plan.variant(17));
  }

  @Test
  void shuffleIsAnotherOrderOfTheSameNumbers() {
    for (long size : new long[] {1, 2, 3, 5, 100, 4097}) {
      Set<Long> places = new TreeSet<>();
      for (long i = 0; i < size; i++) {
        places.add(new Shuffle(size, 11).place(i));
      }
      assertEquals(size, places.size());
      assertTrue(places.stream().allMatch(each -> each >= 0 && each < size));
    }
  }

  @Test
  void numbersAreWrittenAsScriptsReadThem() {
    assertEquals("0.00001", ParameterValue.of(1e-5).text());
    assertEquals("100000000.0", ParameterValue.of(1e8).text());
    assertEquals("0.1", ParameterValue.of(0.1).text());
    assertEquals("3", ParameterValue.of(3.2, true).text());
    assertEquals("0.0", ParameterValue.of(-0.0).text());
  }
}
