package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.NamedTool;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.language.source.Source;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.check.ProgramCheck;
import org.pendant.script.value.Value;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramState;

/** A tree that runs on an arm with mass, which holds a tool of 150 mm straight down. */
final class ArmRun {
  static final Joints START = new Joints(0, -1.5708, -1.5708, -1.5708, 1.5708, 0);
  static final Pose TOOL = new Pose(0, 0, 0.15, 0, 0, 0);

  /** Where the TCP is at first. */
  static final Pose HERE =
      new ForwardKinematics(ArmLibrary.load(ControllerOptions.DEFAULT_ROBOT)).tcpPose(START, TOOL);

  private static final int MAX_FRAMES = 60_000;

  private final Controller controller;
  private final String script;
  private final List<String> said = new ArrayList<>();
  private final List<String> reported = new ArrayList<>();

  ArmRun(ProgramTree tree, Installation installation, ControllerOptions options) {
    assertEquals(List.of(), ProgramCheck.problems(tree, installation));
    script = ScriptGenerator.generate("test", tree, installation).text();
    controller = new Controller(options.withStart(START));
    LoadResult loadResult = controller.load(Source.of("test.script", script));
    assertEquals(List.of(), TestTrees.unexpected(loadResult), script);
    done(new ProgramCommand.StartProgram(loadResult.program().orElseThrow()));
  }

  ArmRun(ProgramTree tree, ControllerOptions options) {
    this(tree, installation(), options);
  }

  /** With nothing around the arm. */
  ArmRun(ProgramTree tree) {
    this(tree, ControllerOptions.headless());
  }

  /** The tool is the active one. */
  static Installation installation() {
    return installation(List.of(), List.of());
  }

  /** The same with features and conveyors. */
  static Installation installation(List<Feature> features, List<ConveyorSetup> conveyors) {
    Installation none = Installation.NONE;
    return new Installation(
        none.robot(),
        none.calibration(),
        List.of(new NamedTool("finger", TOOL)),
        "finger",
        none.payloads(),
        none.activePayload(),
        none.mounting(),
        none.signals(),
        none.wiring(),
        features,
        none.homeRad(),
        none.variables(),
        none.startUp(),
        none.safety(),
        conveyors,
        none.modbus(),
        none.ethernetIpLoss(),
        none.transitionHardness(),
        none.controlHost());
  }

  /** With a table, this far below the tool. */
  static ControllerOptions table(double gapM) {
    SceneObject table =
        new SceneObject.Plane(
            "table",
            new Vector3(0, 0, HERE.z() - gapM),
            new Vector3(0, 0, 1),
            new Material(40_000, 0.2, 0.3));
    return ControllerOptions.headless()
        .withScene(new Scene(List.of(table), Optional.empty(), List.of()));
  }

  /** A place so far from where the TCP is at first, along the axes of the base. */
  static WaypointPosition place(double x, double y, double z) {
    Pose pose = new Pose(HERE.x() + x, HERE.y() + y, HERE.z() + z, HERE.rx(), HERE.ry(), HERE.rz());
    return new WaypointPosition(pose, WaypointPosition.BASE, START, TOOL);
  }

  Reply ask(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    advance(1);
    return reply.join();
  }

  void done(Command command) {
    assertEquals(new Reply.Done(), ask(command));
  }

  void advance(int frames) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
      for (LogEntry entry : state().newEntries()) {
        (entry.origin() == LogEntry.Origin.SCRIPT ? said : reported).add(entry.text());
      }
    }
  }

  boolean running() {
    return state().program().state() == ProgramState.RUNNING;
  }

  /** Continues until the program has said something. */
  ArmRun until(String text) {
    for (int i = 0; i < MAX_FRAMES && !said.contains(text) && running(); i++) {
      advance(1);
    }
    assertTrue(said.contains(text), this::toString);
    return this;
  }

  /** Continues until the program has ended as it should. */
  ArmRun finish() {
    for (int i = 0; i < MAX_FRAMES && running(); i++) {
      advance(1);
    }
    assertEquals(ProgramState.STOPPED, state().program().state(), this::toString);
    assertTrue(!state().program().failed(), this::toString);
    assertEquals(SafetyMode.NORMAL, state().safety().safetyMode(), this::toString);
    return this;
  }

  ControllerState state() {
    return controller.state();
  }

  /** Where the TCP is to be, from where it was at first along the axes of the base, m. */
  Pose moved() {
    Pose now = state().arm().targetTcpInBase();
    return new Pose(now.x() - HERE.x(), now.y() - HERE.y(), now.z() - HERE.z(), 0, 0, 0);
  }

  /** How far the TCP is from a place that {@link #place} gives, m and rad. */
  double distance(double x, double y, double z) {
    return Poses.distance(state().arm().targetTcpInBase(), place(x, y, z).tcp());
  }

  /** With what the tool presses down, N. */
  double pressN() {
    return state().readings().flangeWrenchInBase().fz();
  }

  boolean output(int number) {
    return (state().io().standardOut() >> number & 1) != 0;
  }

  /** A global variable. */
  Value variable(String name) {
    return controller.globals().get(name);
  }

  List<String> said() {
    return said;
  }

  @Override
  public String toString() {
    return "said " + said + ", reported " + reported + " in\n" + script;
  }
}
