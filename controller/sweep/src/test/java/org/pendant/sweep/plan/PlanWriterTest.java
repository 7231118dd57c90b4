package org.pendant.sweep.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import org.junit.jupiter.api.Test;

final class PlanWriterTest {
  private static final long SEED = 20261128;
  private static final List<ParameterTarget> TARGETS =
      List.of(
          new ParameterTarget.Variable("V", OptionalInt.empty()),
          new ParameterTarget.Variable("pick", OptionalInt.of(2)),
          new ParameterTarget.CallArgument(12, "v"),
          new ParameterTarget.MoveFactor("v"),
          new ParameterTarget.MoveFactor("a"),
          new ParameterTarget.Slider(),
          new ParameterTarget.Load(0),
          new ParameterTarget.Load(3),
          new ParameterTarget.BasePlace(FrameAxis.RZ),
          new ParameterTarget.FeaturePlace("the table", FrameAxis.X),
          new ParameterTarget.ObjectPlace("part 1", FrameAxis.RX),
          new ParameterTarget.InputTime("digital_in[0]"));

  private static String text(Random random) {
    return random
        .ints(1 + random.nextInt(8), ' ', 0x250)
        .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
        .insert(0, 'x')
        .toString();
  }

  private static ParameterRange range(Random random, ParameterTarget target, boolean search) {
    if (search || random.nextBoolean()) {
      double from = random.nextGaussian() * Math.pow(10, random.nextInt(-9, 9));
      double to = from + 1e-3 + random.nextDouble() * Math.abs(from);
      return new ParameterRange.Between(from, to, 2 + random.nextInt(5));
    }
    List<ParameterValue> values = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      values.add(
          target.numeric() || random.nextBoolean()
              ? ParameterValue.of(random.nextGaussian())
              : random.nextBoolean()
                  ? ParameterValue.of(random.nextBoolean() ? "True" : "False")
                  : ParameterValue.of(text(random)));
    }
    values.add(ParameterValue.of(random.nextInt(100)));
    return new ParameterRange.Listed(values);
  }

  private static SweepPlan plan(Random random) {
    boolean search = random.nextInt(4) == 0;
    List<SweepParameter> parameters = new ArrayList<>();
    for (ParameterTarget target : TARGETS) {
      if (parameters.isEmpty() || random.nextInt(3) == 0) {
        String name = random.nextBoolean() ? TargetText.of(target) : text(random) + target;
        parameters.add(new SweepParameter(name, target, range(random, target, search)));
      }
    }
    long grid = 1;
    for (SweepParameter each : parameters) {
      grid *= each.gridSize();
    }
    boolean small = grid <= Sampling.MAX_RUNS;
    Sampling sampling =
        search
            ? new Sampling(SamplingMethod.SEARCH, 17, random.nextInt(3))
            : small && random.nextBoolean()
                ? new Sampling(SamplingMethod.GRID, grid, random.nextInt(2))
                : new Sampling(SamplingMethod.LATIN_HYPERCUBE, 40, random.nextInt(2));
    return new SweepPlan(
        "p.toml",
        text(random) + ".script",
        random.nextBoolean() ? Optional.of("ur10e") : Optional.empty(),
        random.nextBoolean() ? Optional.of("a\\b.installation") : Optional.empty(),
        random.nextBoolean() ? Optional.of("cell \"1\".scene.json") : Optional.empty(),
        new RunSettings(
            random.nextBoolean() ? 60 : RunSettings.STANDARD_TIME_S,
            random.nextInt(2),
            random.nextBoolean(),
            random.nextBoolean(),
            random.nextBoolean(),
            random.nextBoolean() ? List.of("a", "b") : List.of(),
            random.nextBoolean() ? List.of("shelf") : List.of(),
            random.nextBoolean() ? List.of("digital_in[0]=true") : List.of()),
        sampling,
        parameters,
        search
            ? Optional.of(
                new SearchGoal(
                    "duration",
                    random.nextBoolean(),
                    List.of("torque_share <= 0.5"),
                    random.nextBoolean() ? SearchGoal.standardPopulation(parameters.size()) : 20,
                    random.nextBoolean() ? SearchGoal.STANDARD_STALL : 3))
            : Optional.empty());
  }

  @Test
  void anyPlanThatIsWrittenIsReadAsTheSame() throws PlanException {
    Random random = new Random(SEED);
    for (int i = 0; i < 1000; i++) {
      SweepPlan plan = plan(random);
      String text = PlanWriter.write(plan);
      assertEquals(plan, PlanReader.read("p.toml", text), () -> "seed " + SEED + "\n" + text);
    }
  }

  @Test
  void whatIsSoAnywayIsNotWritten() throws PlanException {
    String text =
        """
        program = "a.script"

        [[parameter]]
        set = "speed"
        from = 0.5
        to = 1
        steps = 3
        """;
    assertEquals(text, PlanWriter.write(PlanReader.read("p.toml", text)));
  }

  @Test
  void aTargetThatIsWrittenMeansTheSame() {
    for (ParameterTarget each : TARGETS) {
      assertEquals(Optional.of(each), TargetText.parse(TargetText.of(each)));
    }
    assertFalse(TargetText.parse("pace").isPresent());
  }
}
