package org.pendant.project.program;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;

/** What nodes are called in the tree. */
final class StepNamesTest {
  private static void assertCalled(String label, Step step) {
    assertEquals(label, StepNames.label(step));
  }

  private static Step direction(double x, double y, double z) {
    return new MotionStep.Direction(
        "Base", x, y, z, OptionalDouble.empty(), OptionalDouble.empty());
  }

  private static Step waypoint(WaypointTarget target) {
    return new MotionStep.Waypoint(target, new Timing.AsMove(), OptionalDouble.empty());
  }

  private static Step move(MoveKind kind) {
    return new MotionStep.Move(kind, 1, 1, new ToolChoice.Active(), "Base", false);
  }

  @Test
  void movesAreCalledByTheirKindAndPlacesByTheirName() {
    assertCalled("MoveJ", move(MoveKind.JOINT));
    assertCalled("MoveL", move(MoveKind.LINEAR));
    assertCalled("MoveP", move(MoveKind.PROCESS));
    assertCalled("Waypoint_1", waypoint(new WaypointTarget.Fixed("Waypoint_1")));
    assertCalled("up", waypoint(new WaypointTarget.Relative("up", "a", "b")));
    assertCalled("spot", waypoint(new WaypointTarget.Variable("spot")));
    assertCalled("Home", new MotionStep.Home(1, 1, OptionalDouble.empty()));
  }

  @Test
  void directionsAreCalledByTheirAxis() {
    assertCalled("Direction: Base Z-", direction(0, 0, -2));
    assertCalled("Direction: Base X+", direction(1, 0, 0));
    assertCalled("Direction: Base [1, 0, 0.5]", direction(1, 0, 0.5));
    assertCalled("Until distance: 0.1 m", new MotionStep.Until(new UntilRule.Distance(0.1)));
  }

  @Test
  void conditionsShowTheSignForEqual() {
    assertCalled("If digital_in[0] \u225f True", new FlowStep.If("digital_in[0] == True", false));
    assertCalled("x \u2254 1", new ActionStep.Assignment("x", "1"));
    assertCalled(
        "Wait digital_in[0] \u225f False",
        new ActionStep.Wait(new WaitFor.Digital("digital_in[0]", false)));
  }

  @Test
  void aPopupThatSaysNothingHasNoColon() {
    assertCalled("Popup", new ActionStep.Popup("", false, ActionStep.PopupKind.MESSAGE, false));
    assertCalled(
        "Popup: Tray", new ActionStep.Popup("Tray", false, ActionStep.PopupKind.MESSAGE, false));
  }

  @Test
  void numbersHaveNoNeedlessFraction() {
    assertCalled("Wait: 0.5", new ActionStep.Wait(new WaitFor.Time(0.5)));
    assertCalled("Wait: 2", new ActionStep.Wait(new WaitFor.Time(2)));
    assertCalled("Wait: 1.0E30", new ActionStep.Wait(new WaitFor.Time(1e30)));
  }

  @Test
  void whatIsNotFilledInIsAQuestionMark() {
    assertCalled("If ?", new FlowStep.If("", true));
    assertCalled("? \u2254 ?", new ActionStep.Assignment("", " "));
    assertCalled("?", waypoint(new WaypointTarget.Fixed("")));
    assertCalled("Set ? = On", new ActionStep.SetAction(new Setting.Digital("", true)));
    assertCalled("Folder", new ActionStep.Folder(""));
  }

  @Test
  void textsStayOnOneLine() {
    assertCalled("'one two'", new ActionStep.Comment("one\n  two"));
    assertCalled("a = 1 b = 2", new ActionStep.ScriptLine("a = 1\nb = 2\n"));
  }

  @Test
  void settingsSayWhatTheySet() {
    assertCalled("Set TCP", new ActionStep.SetAction(new Setting.Tcp("", Pose.ZERO)));
    assertCalled("Set TCP: pen", new ActionStep.SetAction(new Setting.Tcp("pen", Pose.ZERO)));
    assertCalled(
        "Set payload: 1.5 kg", new ActionStep.SetAction(new Setting.Payload(1.5, 0, 0, 0)));
    assertCalled("Grip: Acme", new ForeignStep.Contributed("Acme", "Grip", List.of(), List.of()));
  }

  @Test
  void signalsAreCalledByTheirNamesWherePeopleRead() {
    Step wait = new ActionStep.Wait(new WaitFor.Digital("digital_in[0]", true));
    Step pulse = new ActionStep.SetAction(new Setting.Pulse("digital_out[3]", 0.5));
    Step until = new MotionStep.Until(new UntilRule.DigitalInput("digital_in[0]", true));
    assertEquals("Wait <digital_in[0]> \u225f True", StepNames.label(wait, StepNamesTest::named));
    assertEquals("Set <digital_out[3]>: pulse 0.5", StepNames.label(pulse, StepNamesTest::named));
    assertEquals("Until <digital_in[0]> \u225f True", StepNames.label(until, StepNamesTest::named));
  }

  private static String named(String signal) {
    return "<" + signal + ">";
  }
}
