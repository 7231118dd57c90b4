package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/** A controller whose arm an operator guides, with a hand that repeats what a screen repeats. */
final class GuidedArm {
  /** How often a screen repeats, in frames: 30 times a second. */
  static final int REPEAT_FRAMES = 17;

  final Controller controller;
  private final ManualCommand.StartFreedrive start;

  GuidedArm(ControllerOptions options, FreeAxes axes, FreedriveFrame frame) {
    controller = new Controller(options);
    start = new ManualCommand.StartFreedrive(axes, frame);
  }

  /** A UR5e with mass that may be guided any way. */
  static GuidedArm free() {
    return new GuidedArm(ControllerOptions.headless(), FreeAxes.ALL, FreedriveFrame.BASE);
  }

  Reply ask(Command command) {
    return TestController.ask(controller, command);
  }

  void done(Command command) {
    TestController.done(controller, command);
  }

  String refusal(Command command) {
    return assertInstanceOf(Reply.Refused.class, ask(command)).refusal().text();
  }

  /** Guides for this many seconds of the robot, and repeats that as a screen does. */
  void guide(double seconds) {
    guide(seconds, () -> {});
  }

  /**
   * As {@link #guide(double)}.
   *
   * @param each runs after every frame
   */
  void guide(double seconds, Runnable each) {
    for (int frame = 0; frame < seconds / 0.002; frame++) {
      if (frame % REPEAT_FRAMES == 0) {
        done(start);
      } else {
        controller.advance();
      }
      each.run();
    }
  }

  /** Asks for freedrive once. */
  Reply hold() {
    return ask(start);
  }

  void end() {
    done(new ManualCommand.EndFreedrive());
  }

  void frames(int count) {
    controller.runUntil(() -> false, count);
  }

  void push(double x, double y, double z) {
    done(new WorldCommand.PushTool(new Wrench(x, y, z, 0, 0, 0)));
  }

  ControllerState state() {
    return controller.state();
  }

  ArmState arm() {
    return state().arm();
  }

  Joints position() {
    return arm().actualPositionRad();
  }

  Pose tcp() {
    return arm().actualTcpInBase();
  }

  /** How far the tool is from a place, m. */
  double distance(Pose from) {
    Pose now = tcp();
    return Math.sqrt(
        Math.pow(now.x() - from.x(), 2)
            + Math.pow(now.y() - from.y(), 2)
            + Math.pow(now.z() - from.z(), 2));
  }

  List<String> said() {
    return controller.logSince(0).stream().map(LogEntry::text).toList();
  }
}
