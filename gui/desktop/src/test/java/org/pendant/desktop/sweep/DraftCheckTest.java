package org.pendant.desktop.sweep;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.sweep.DraftParameter.Part;
import org.pendant.sweep.plan.ParameterTarget;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.PlanReader;
import org.pendant.sweep.plan.SamplingMethod;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.run.ParameterOffer;

final class DraftCheckTest {
  private static final ParameterTarget FAST =
      new ParameterTarget.Variable("FAST", OptionalInt.empty());
  private static final ParameterTarget SLIDER = new ParameterTarget.Slider();
  private static final ParameterTarget ROBOT = new ParameterTarget.RobotModel();
  private static final Path FOLDER = Path.of("cell").toAbsolutePath();

  private static PlanDraft draft() {
    return PlanDraft.of(
            new PlanDraft.Files(
                FOLDER.resolve("plans/p.toml"),
                FOLDER.resolve("pick.script"),
                Optional.empty(),
                Optional.of(FOLDER.resolve("plans/cell.scene.json")),
                "ur5e"))
        .offering(
            List.of(
                new ParameterOffer(
                    ParameterOffer.Group.VARIABLES, FAST, "0.5", "", "0.25", "0.75", ""),
                new ParameterOffer(ParameterOffer.Group.ROBOT, SLIDER, "1", "", "0.2", "1", ""),
                new ParameterOffer(
                    ParameterOffer.Group.ROBOT, ROBOT, "ur5e", "", "", "", "ur3e, ur5e")));
  }

  private static PlanDraft choosing(PlanDraft draft, ParameterTarget... targets) {
    return draft.withParameters(
        draft.parameters().stream()
            .map(each -> List.of(targets).contains(each.target()) ? each.withChosen(true) : each)
            .toList());
  }

  private static PlanDraft typing(PlanDraft draft, ParameterTarget target, Part part, String text) {
    return draft.withParameters(
        draft.parameters().stream()
            .map(each -> each.target().equals(target) ? each.with(part, text) : each)
            .toList());
  }

  private static String error(PlanDraft draft, ParameterTarget target, Part part) {
    return DraftCheck.of(draft).errors().getOrDefault(DraftCheck.field(target, part), "");
  }

  @Test
  void whatIsTickedBecomesAPlanThatTheCommandRunsToo() throws PlanException {
    DraftCheck.Outcome outcome = DraftCheck.of(choosing(draft(), FAST, ROBOT));
    assertEquals(Map.of(), outcome.errors());
    assertEquals(
        """
        program = "../pick.script"
        robot = "ur5e"
        scene = "cell.scene.json"

        [[parameter]]
        name = "FAST"
        set = "variable FAST"
        from = 0.25
        to = 0.75
        steps = 5

        [[parameter]]
        set = "robot"
        values = ["ur3e", "ur5e"]
        """,
        outcome.text());
    assertEquals(10, outcome.plan().orElseThrow().size());
    assertEquals(PlanReader.read("plan", outcome.text()), outcome.plan().get());
  }

  @Test
  void aPlanThatIsOpenedAndNotChangedMeansTheSame() throws PlanException {
    String text =
        """
        program = "pick.script"
        noise = "measured"
        variables = ["n", "m"]
        inputs = ["digital_in[0]=true"]
        time_limit = 12.5

        [search]
        maximize = "singularity"
        limits = ["outcome == finished", "force < 20"]
        runs = 90
        population = 5
        stall = 4
        seed = 3

        [[parameter]]
        set = "variable FAST"
        from = 0.25
        to = 0.75

        [[parameter]]
        name = "share"
        set = "slider"
        from = 0.2
        to = 1
        """;
    SweepPlan plan = PlanReader.read("plan", text);
    PlanDraft.Files files =
        new PlanDraft.Files(
            FOLDER.resolve("p.toml"),
            FOLDER.resolve("pick.script"),
            Optional.empty(),
            Optional.empty(),
            "");
    PlanDraft opened = PlanDraft.of(files, plan).offering(List.of());
    SweepPlan again = DraftCheck.of(opened).plan().orElseThrow();
    assertEquals(plan.settings(), again.settings());
    assertEquals(plan.search(), again.search());
    assertEquals(plan.sampling(), again.sampling());
    assertEquals(
        plan.parameters().stream().map(each -> each.name() + each.target()).toList(),
        again.parameters().stream().map(each -> each.name() + each.target()).toList());
    assertEquals(plan.parameters().getLast().at(0.5), again.parameters().getLast().at(0.5));
  }

  @Test
  void whatIsWrongIsToldAtItsField() {
    PlanDraft draft = choosing(draft(), FAST);
    assertEquals("", error(draft, FAST, Part.FROM));
    assertTrue(error(typing(draft, FAST, Part.FROM, "fast"), FAST, Part.FROM).contains("'fast'"));
    assertTrue(error(typing(draft, FAST, Part.TO, "0.1"), FAST, Part.TO).contains("above from"));
    assertTrue(error(typing(draft, FAST, Part.STEPS, "1"), FAST, Part.STEPS).contains("2 to"));
    assertTrue(error(typing(draft, FAST, Part.NAME, " "), FAST, Part.NAME).contains("no name"));
    assertTrue(
        error(typing(draft, SLIDER, Part.VALUES, "0.5, half"), SLIDER, Part.VALUES)
            .contains("'half'"));
    assertTrue(
        error(typing(draft, ROBOT, Part.VALUES, ""), ROBOT, Part.VALUES).contains("ur5e, ur10e"));
    PlanDraft random = draft.with(draft.sampling().withMethod(SamplingMethod.RANDOM).withRuns("x"));
    assertTrue(DraftCheck.of(random).errors().get("runs").contains("'x'"));
    assertTrue(
        DraftCheck.of(draft.with(draft.settings().withTimeLimit("0")))
            .errors()
            .get("time-limit")
            .contains("0.002"));
  }

  @Test
  void aSearchNeedsRangesAndColumnsThatThereAre() {
    PlanDraft search =
        choosing(draft(), FAST).with(draft().sampling().withMethod(SamplingMethod.SEARCH));
    assertEquals(Map.of(), DraftCheck.of(search).errors());
    assertTrue(
        error(typing(search, FAST, Part.VALUES, "1, 2"), FAST, Part.VALUES).contains("search"));
    assertTrue(
        DraftCheck.of(search.with(search.sampling().withColumn("time")))
            .errors()
            .get("goal")
            .contains("time"));
    assertTrue(
        DraftCheck.of(search.with(search.sampling().withLimits("duraton < 3")))
            .errors()
            .get("limits")
            .contains("did you mean duration"));
  }

  @Test
  void listsOfAListHaveTheSameLength() {
    PlanDraft list =
        typing(choosing(draft(), FAST, SLIDER), FAST, Part.VALUES, "1, 2, 3")
            .with(draft().sampling().withMethod(SamplingMethod.LIST));
    assertTrue(error(list, SLIDER, Part.VALUES).contains("must have 3 as FAST"));
    assertEquals(
        3, DraftCheck.of(typing(list, SLIDER, Part.STEPS, "3")).plan().orElseThrow().size());
  }

  @Test
  void valuesAreSplitAtCommasOutsideOfBracketsAndTexts() {
    assertEquals(
        List.of("p[0.4, 0, 0.2, 0, 3.14, 0]", "\"a, b\"", "f(1, 2)"),
        DraftCheck.split("p[0.4, 0, 0.2, 0, 3.14, 0], \"a, b\" , f(1, 2)"));
  }
}
