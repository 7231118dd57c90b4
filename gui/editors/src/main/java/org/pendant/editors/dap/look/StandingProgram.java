package org.pendant.editors.dap.look;

import static org.pendant.editors.dap.look.LookTexts.text;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ThreadSnapshot;

/** Standing program: a moment at which a program stands still, so that it can be looked at. */
public interface StandingProgram {
  /** The threads and their calls, the main thread first. */
  List<ThreadSnapshot> threads();

  /** The robot. */
  ControllerState state();

  /**
   * What can be seen from a call.
   *
   * @param depth of it, 1 for the outermost
   */
  CompletableFuture<List<Scope>> scopes(int thread, int depth);

  /** The value of an expression in a call. */
  CompletableFuture<Shown> evaluate(int thread, int depth, String expression);

  /** Gives a variable or a part of one a value; what it is then. */
  CompletableFuture<Shown> assign(int thread, int depth, String target, String value);

  /**
   * Variables that belong together.
   *
   * @param name that people read
   * @param kind of them, in the protocol's words; empty for none
   */
  record Scope(String name, String kind, Branch branch) {}

  /** What a snapshot has of the robot. */
  static List<Scope> ofRobot(ControllerState state) {
    return List.of(
        new Scope("I/O", "", RobotBranches.signals(state)),
        new Scope(text("registers"), "", RobotBranches.registers(state)),
        new Scope(text("robot"), "", RobotBranches.robot(state)));
  }
}
