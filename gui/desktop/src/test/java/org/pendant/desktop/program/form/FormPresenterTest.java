package org.pendant.desktop.program.form;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Setting;
import org.pendant.project.program.Step;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;
import org.pendant.project.program.check.NodeProblem;
import org.pendant.project.program.text.ProgramText;

final class FormPresenterTest {
  private static final double CLOSE = 1e-9;

  private ControllerState state;
  private FakeHost host;
  private FormPresenter presenter;
  private String fileText = "";

  @BeforeEach
  void start() {
    state = new Controller(ControllerOptions.headless()).state();
  }

  private final class FakeFiles implements FormFiles {
    @Override
    public void choose(String title, String ending, Consumer<Path> chosen) {
      chosen.accept(Path.of("/programs/parts/chosen" + ending));
    }

    @Override
    public void read(Path file, Consumer<String> text, Consumer<String> failed) {
      text.accept(fileText);
    }
  }

  private void open(ProgramTree tree) {
    host = new FakeHost(tree, state);
    host.setInstallation(EveryNode.installation());
    presenter = new FormPresenter(host, new FakeFiles());
    host.whenChanged(() -> presenter.select(selected()));
  }

  private Optional<ProgramNode> selected() {
    return presenter.key().isPresent()
        ? host.tree().find(presenter.key().getAsLong())
        : Optional.empty();
  }

  /** A program of these nodes; the first of them is selected. */
  private void open(ProgramNode... nodes) {
    ProgramTree empty = ProgramTree.empty();
    long main = empty.sections().getFirst().key();
    open(empty.insert(main, 0, List.of(nodes)));
    select(host.tree().childrenOf(main).getFirst());
  }

  private void select(ProgramNode node) {
    presenter.select(Optional.of(node));
  }

  private Step step() {
    return selected().orElseThrow().step();
  }

  private Item item(String name) {
    return presenter.form().orElseThrow().item(name).orElseThrow();
  }

  private void press(String name) {
    for (Item each : presenter.form().orElseThrow().items().toList()) {
      if (each instanceof Item.Presses presses) {
        for (Item.Press button : presses.buttons()) {
          if (button.name().equals(name)) {
            button.press().run();
            return;
          }
        }
      }
    }
    throw new AssertionError("no button " + name);
  }

  private static ProgramNode fixed(String name) {
    return node(
        new MotionStep.Waypoint(
            new WaypointTarget.Fixed(name), new Timing.AsMove(), OptionalDouble.empty()));
  }

  private static ProgramNode move(MoveKind kind, ProgramNode... children) {
    return node(
        new MotionStep.Move(
            kind, Math.toRadians(60), Math.toRadians(80), new ToolChoice.Active(), "Base", false),
        children);
  }

  private WaypointPosition here() {
    return Taught.here(state, EveryNode.installation(), "Base");
  }

  @Test
  void everyNodeHasAFormWhoseItemsHaveNamesOfTheirOwn() {
    open(EveryNode.tree(state));
    for (ProgramNode node : host.tree().nodes()) {
      select(node);
      NodeForm form = presenter.form().orElseThrow();
      Set<String> names = new HashSet<>();
      form.items().forEach(each -> assertTrue(names.add(each.name()), form.kind() + each.name()));
      assertFalse(form.title().isBlank());
      assertTrue(form.about().endsWith("."), form.about());
    }
  }

  @Test
  void nothingIsShownOfNoNode() {
    open(node(new ActionStep.Halt()));
    presenter.select(Optional.empty());
    assertTrue(presenter.form().isEmpty());
  }

  @Test
  void takesNumbersInTheUnitsOfTheScreen() {
    open(move(MoveKind.JOINT));
    assertEquals("", presenter.typeNumber("speed", "90"));
    assertEquals(Math.PI / 2, ((MotionStep.Move) step()).speed(), CLOSE);
    assertEquals("", presenter.typeNumber("acceleration", "45,5 deg/s\u00b2"));
    assertEquals(Math.toRadians(45.5), ((MotionStep.Move) step()).acceleration(), CLOSE);
    assertEquals(List.of("Change joint speed", "Change acceleration"), host.told());
  }

  @Test
  void speedsAndTheTcpAreInTheUnitsThatPeopleHaveChosen() {
    open(move(MoveKind.LINEAR));
    host.setPoseForm(
        new PoseForm(DisplayUnit.INCH, DisplayUnit.RADIAN, RotationForm.ROLL_PITCH_YAW));
    select(selected().orElseThrow());
    assertEquals("", presenter.typeNumber("speed", "10"));
    assertEquals(0.254, ((MotionStep.Move) step()).speed(), CLOSE);
    assertEquals("must be above 0 and at most 196.8504 in/s", presenter.typeNumber("speed", "900"));

    open(node(new ActionStep.SetAction(new Setting.Tcp("", Pose.ZERO))));
    host.setPoseForm(
        new PoseForm(DisplayUnit.METRE, DisplayUnit.RADIAN, RotationForm.ROLL_PITCH_YAW));
    select(selected().orElseThrow());
    Item.Grid pose = (Item.Grid) item("setting.inFlange");
    assertEquals(
        List.of("m", "m", "m", "rad", "rad", "rad"),
        pose.numbers().stream().map(each -> each.measure().symbol()).toList());
    assertEquals(
        host.poseForm().labels(), pose.numbers().stream().map(each -> each.label()).toList());
    assertEquals("", presenter.typeNumber(pose.numbers().get(2).name(), "0.12"));
    assertEquals(
        new Pose(0, 0, 0.12, 0, 0, 0),
        ((Setting.Tcp) ((ActionStep.SetAction) step()).setting()).inFlange());
  }

  @Test
  void keepsTheLastNumberWhenSomethingElseIsTyped() {
    open(move(MoveKind.JOINT));
    assertEquals("'fast' is not a number in deg/s", presenter.typeNumber("speed", "fast"));
    assertEquals("must be above 0 and at most 360 deg/s", presenter.typeNumber("speed", "361"));
    assertEquals("must be above 0 and at most 360 deg/s", presenter.typeNumber("speed", "0"));
    assertEquals(Math.toRadians(60), ((MotionStep.Move) step()).speed(), CLOSE);
    assertEquals(List.of(), host.told());
  }

  @Test
  void noNumberMeansWhatTheFieldSays() {
    open(node(new MotionStep.Home(1, 1, OptionalDouble.of(2))));
    assertEquals("", presenter.typeNumber("timeS", " "));
    assertEquals(OptionalDouble.empty(), ((MotionStep.Home) step()).timeS());
    assertEquals("empty, must be a number in deg/s", presenter.typeNumber("speedRadPerS", ""));
  }

  @Test
  void changingTheKindBackBringsBackWhatWasTyped() {
    open(node(new ActionStep.Wait(new WaitFor.Time(0.5))));
    presenter.choose("what", "digital");
    presenter.choose("what.signal", "digital_in[4]");
    presenter.choose("what", "time");
    assertEquals(new ActionStep.Wait(new WaitFor.Time(0.5)), step());
    presenter.choose("what", "digital");
    assertEquals(new ActionStep.Wait(new WaitFor.Digital("digital_in[4]", true)), step());
  }

  @Test
  void anotherNodeBeginsWithTheUsualValues() {
    open(
        node(new ActionStep.Wait(new WaitFor.Time(0.5))),
        node(new ActionStep.Wait(new WaitFor.Nothing())));
    ProgramNode second = host.tree().nodes().get(2);
    presenter.choose("what", "digital");
    select(second);
    presenter.choose("what", "time");
    assertEquals(new ActionStep.Wait(new WaitFor.Time(0.01)), step());
  }

  @Test
  void anAssignmentBecomesAQuestionAndBack() {
    open(node(new ActionStep.Assignment("count", "1 + 1")));
    presenter.choose("source", "operator");
    assertEquals("count", ((ActionStep.OperatorInput) step()).variable());
    presenter.choose("source", "expression");
    assertEquals(new ActionStep.Assignment("count", "1 + 1"), step());
  }

  @Test
  void betweenJointsAndToolSpeedsAreNotMixed() {
    ProgramNode own =
        node(
            new MotionStep.Waypoint(
                new WaypointTarget.Fixed("A"), new Timing.Own(1, 2), OptionalDouble.empty()));
    open(move(MoveKind.JOINT, own));
    presenter.choose("kind", MoveKind.LINEAR.name());
    assertEquals(0.25, ((MotionStep.Move) step()).speed());
    MotionStep.Waypoint waypoint =
        (MotionStep.Waypoint) selected().orElseThrow().children().getFirst().step();
    assertEquals(new Timing.AsMove(), waypoint.timing());
    presenter.choose("kind", MoveKind.JOINT.name());
    assertEquals(Math.toRadians(60), ((MotionStep.Move) step()).speed(), CLOSE);
  }

  @Test
  void aWaypointIsRenamedWhereverItIsUsed() {
    open(move(MoveKind.JOINT, fixed("A"), fixed("B"), fixed("A")));
    host.change("Teach", host.tree().withWaypoint("A", here()));
    ProgramNode first = selected().orElseThrow().children().getFirst();
    select(first);
    assertEquals("", presenter.typeText("target.name", "Pick"));
    assertEquals(Set.of("Pick"), host.tree().waypoints().keySet());
    List<ProgramNode> nodes = host.tree().nodes().get(1).children();
    assertEquals(fixed("Pick").step(), nodes.get(0).step());
    assertEquals(fixed("B").step(), nodes.get(1).step());
    assertEquals(fixed("Pick").step(), nodes.get(2).step());
  }

  @Test
  void theNameOfAnotherWaypointIsRefused() {
    open(move(MoveKind.JOINT, fixed("A"), fixed("B")));
    select(selected().orElseThrow().children().getFirst());
    assertEquals(
        "'B' is another waypoint; choose it under Position of to share its place",
        presenter.typeText("target.name", "B"));
    presenter.choose("position", "B");
    assertEquals(fixed("B").step(), step());
    press("make-own");
    assertEquals(fixed("Waypoint_1").step(), step());
  }

  @Test
  void aWaypointIsSetToWhereTheArmIs() {
    open(move(MoveKind.JOINT, fixed("A")));
    select(selected().orElseThrow().children().getFirst());
    press("position-here");
    assertEquals(here(), host.tree().waypoints().get("A"));
  }

  @Test
  void aCornerGetsANameWhenItIsTaught() {
    open(EveryNode.tree(state));
    ProgramNode pallet =
        host.tree().nodes().stream()
            .filter(each -> each.step().getClass().getSimpleName().equals("Palletizing"))
            .findFirst()
            .orElseThrow();
    select(pallet);
    press("pattern.last-teach");
    assertEquals("teach pallet_corner_1", host.told().getLast());
  }

  @Test
  void jointsAndPoseOfAWaypointBelongTogether() {
    open(move(MoveKind.JOINT, fixed("A")));
    host.change("Teach", host.tree().withWaypoint("A", here()));
    select(selected().orElseThrow().children().getFirst());
    double before = here().tcp().z();
    assertEquals("", presenter.typeNumber("joint-3", "-80"));
    WaypointPosition turned = host.tree().waypoints().get("A");
    assertTrue(Math.abs(turned.tcp().z() - before) > 1e-3);
    assertEquals("", presenter.typeNumber("pose-z", "600"));
    WaypointPosition raised = host.tree().waypoints().get("A");
    assertEquals(0.6, raised.tcp().z(), CLOSE);
    assertEquals(
        0.6,
        Taught.withJoints(
                raised, raised.jointsRad(), state.arm().description(), EveryNode.installation())
            .tcp()
            .z(),
        1e-6);
  }

  @Test
  void anglesInSentencesAreInTheUnitThatPeopleHaveChosen() {
    PoseForm radians =
        new PoseForm(DisplayUnit.INCH, DisplayUnit.RADIAN, RotationForm.ROLL_PITCH_YAW);
    open(node(new MotionStep.Home(1, 1, OptionalDouble.empty())));
    host.setPoseForm(radians);
    select(selected().orElseThrow());
    Item.Note home = assertInstanceOf(Item.Note.class, item("place"));
    assertTrue(home.text().startsWith("Joints in rad: base 0, shoulder -1.570796, "), home.text());

    open(move(MoveKind.JOINT, fixed("A")));
    host.setPoseForm(radians);
    host.change("Teach", host.tree().withWaypoint("A", here()));
    select(selected().orElseThrow().children().getFirst());
    assertEquals("", presenter.typeNumber("joint-5", "6.3"));
    Item.Note note = assertInstanceOf(Item.Note.class, item("reach"));
    assertEquals(
        "Wrist 3 is within 0.087266 rad of the end of its range, -6.335545 to 6.335545 rad.",
        note.text());
  }

  @Test
  void aPoseOutOfReachIsKeptAndTold() {
    open(move(MoveKind.JOINT, fixed("A")));
    host.change("Teach", host.tree().withWaypoint("A", here()));
    select(selected().orElseThrow().children().getFirst());
    assertEquals("", presenter.typeNumber("pose-z", "3000"));
    Item.Note note = assertInstanceOf(Item.Note.class, item("reach"));
    assertTrue(note.text().startsWith("The arm cannot reach this pose"), note.text());
  }

  @Test
  void problemsStandAtTheFieldThatTheyAreAbout() {
    open(node(new ActionStep.Wait(new WaitFor.Expression(""))));
    long key = presenter.key().getAsLong();
    host.addProblem(new NodeProblem(key, "what", "the condition is missing"));
    host.addProblem(new NodeProblem(key, "", "it is in the wrong place"));
    NodeForm form = presenter.form().orElseThrow();
    assertEquals("the condition is missing", presenter.problem(form, "what.condition"));
    assertEquals("", presenter.problem(form, "what"));
    assertEquals(List.of("it is in the wrong place"), presenter.problems(form));
  }

  @Test
  void aProblemThatMayBeAboutSeveralFieldsStandsWhereTheyWereChosen() {
    open(node(new ActionStep.Wait(new WaitFor.Analog("analog_in[7]", true, 2))));
    long key = presenter.key().getAsLong();
    host.addProblem(new NodeProblem(key, "what", "there is no analog_in[7]"));
    NodeForm form = presenter.form().orElseThrow();
    assertEquals("there is no analog_in[7]", presenter.problem(form, "what"));
    assertEquals("", presenter.problem(form, "what.signal"));
  }

  @Test
  void aProblemWithAListIsToldOfTheNode() {
    open(EveryNode.tree(state));
    ProgramNode values = host.tree().sections().getFirst();
    host.addProblem(new NodeProblem(values.key(), "values", "'2wrong' is no name"));
    select(values);
    NodeForm form = presenter.form().orElseThrow();
    assertEquals("", presenter.problem(form, "values.0.variable"));
    assertEquals(List.of("'2wrong' is no name"), presenter.problems(form));
  }

  @Test
  void aMissingFeatureIsTold() {
    open(
        node(
            new MotionStep.Direction(
                "Gone", 0, 0, 1, OptionalDouble.empty(), OptionalDouble.empty())));
    Item.Choice choice = assertInstanceOf(Item.Choice.class, item("feature"));
    assertEquals("'Gone' is no feature of the installation", choice.problem());
  }

  @Test
  void theFormFollowsUndo() {
    open(node(new ActionStep.Folder("A")));
    assertEquals("", presenter.typeText("name", "B"));
    host.undo();
    assertEquals("A", ((Item.Text) item("name")).value());
  }

  @Test
  void branchesAreAddedBehindTheirGroup() {
    open(
        node(new FlowStep.If("True", false)),
        node(new FlowStep.ElseIf("a")),
        node(new ActionStep.Halt()));
    press("add-else");
    press("add-else-if");
    List<Step> steps =
        host.tree().sections().getFirst().children().stream().map(ProgramNode::step).toList();
    assertEquals(
        List.of(
            new FlowStep.If("True", false),
            new FlowStep.ElseIf(""),
            new FlowStep.ElseIf("a"),
            new FlowStep.Else(),
            new ActionStep.Halt()),
        steps);
  }

  @Test
  void aSubProgramIsRenamedWhereItIsCalled() {
    open(node(new ActionStep.Call("Pick")));
    host.change(
        "Add",
        host.tree().insert(ProgramTree.ROOT, 1, List.of(node(new Section.SubProgram("Pick", "")))));
    select(host.tree().sections().get(1));
    assertEquals("", presenter.typeText("name", "Take"));
    assertEquals(new ActionStep.Call("Take"), host.tree().nodes().get(1).step());
  }

  @Test
  void initialValuesAreAddedChangedAndRemoved() {
    open(ProgramTree.empty());
    host.change(
        "Add",
        host.tree()
            .insert(ProgramTree.ROOT, 0, List.of(node(new Section.InitialValues(List.of())))));
    select(host.tree().sections().getFirst());
    press("add-value");
    assertEquals("", presenter.typeText("values.0.variable", "count"));
    assertEquals("", presenter.typeText("values.0.expression", "3"));
    assertEquals(
        new Section.InitialValues(List.of(new Section.InitialValue("count", "3"))), step());
    assertEquals(
        "'3count' is no name, expected letters, digits and _, no digit first",
        presenter.typeText("values.0.variable", "3count"));
    press("values.0-remove");
    assertEquals(new Section.InitialValues(List.of()), step());
  }

  @Test
  void aWordOfTheLanguageIsNoNameOfAVariable() {
    open(node(new ActionStep.Timer("t", ActionStep.TimerAction.START)));
    assertEquals(
        "'while' is a word of the language, expected another name",
        presenter.typeText("name", "while"));
    assertEquals("", presenter.typeText("name", "while_away"));
    assertEquals(new ActionStep.Timer("while_away", ActionStep.TimerAction.START), step());
  }

  @Test
  void aDistanceThatEndsAMoveMayHaveARoundCorner() {
    open(node(new MotionStep.Until(new UntilRule.Distance(0.2))));
    presenter.choose("blend", "false");
    assertEquals(
        new MotionStep.Until(new UntilRule.Distance(0.2, OptionalDouble.of(0.025))), step());
    assertEquals("", presenter.typeNumber("rule.blendRadiusM", "50"));
    assertEquals(
        new MotionStep.Until(new UntilRule.Distance(0.2, OptionalDouble.of(0.05))), step());
  }

  @Test
  void theStubOfAContributedNodeIsEdited() {
    open(node(new ForeignStep.Contributed("cap", "Node", List.of("<x/>"), List.of())));
    assertEquals("", presenter.typeText("stub", "sync()\nsleep(1)"));
    assertEquals(
        new ForeignStep.Contributed("cap", "Node", List.of("<x/>"), List.of("sync()", "sleep(1)")),
        step());
  }

  @Test
  void externalControlSaysWhomItAsksUnlessAStubStandsInForIt() {
    open(node(new ForeignStep.Contributed("FZI", "External Control", List.of("<x/>"), List.of())));
    assertEquals("External Control", presenter.form().orElseThrow().title());
    assertTrue(presenter.form().toString().contains("Asks 192.168.56.1:50002"));
    assertEquals("", presenter.typeText("stub", "sync()"));
    assertEquals("Contributed node", presenter.form().orElseThrow().title());
  }

  @Test
  void aScriptFileIsReadIntoTheProgram() {
    open(node(new ActionStep.ScriptFile("", List.of())));
    fileText = "sync()\nsleep(1)\n";
    press("file-choose");
    assertEquals(
        new ActionStep.ScriptFile(
            Path.of("/programs/parts/chosen.script").toAbsolutePath().toString(),
            List.of("sync()", "sleep(1)")),
        step());
  }

  @Test
  void aProgramThatIsCopiedInDoesNotMixUpPlaces() {
    open(move(MoveKind.JOINT, fixed("A")));
    ProgramTree other = host.tree();
    WaypointPosition elsewhere =
        Taught.withJoints(
            here(),
            here().jointsRad().with(0, 1),
            state.arm().description(),
            EveryNode.installation());
    fileText = ProgramText.write(other.withWaypoint("A", elsewhere));
    host.change(
        "Add",
        host.tree()
            .withWaypoint("A", here())
            .insert(ProgramTree.ROOT, 1, List.of(node(new Section.SubProgram("Sub", "")))));
    select(host.tree().sections().get(1));
    press("file-choose");
    assertEquals(here(), host.tree().waypoints().get("A"));
    assertEquals(elsewhere, host.tree().waypoints().get("A_1"));
    ProgramNode copied = host.tree().sections().get(1).children().getFirst();
    assertEquals(fixed("A_1").step(), copied.children().getFirst().step());
  }

  @Test
  void aSuppressedNodeIsUsedAgain() {
    open(node(new ActionStep.Halt()));
    long key = presenter.key().getAsLong();
    host.change("Suppress", host.tree().withNode(key, each -> each.withSuppressed(true)));
    assertTrue(presenter.suppressed());
    presenter.useAgain();
    assertFalse(presenter.suppressed());
  }
}
