package org.pendant.desktop.program.form;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.check.NodeProblem;

/**
 * Form host: what the forms of nodes may use of the program that they edit. Only the dispatch
 * thread calls.
 */
public interface FormHost {

  /** The program as it is now. */
  ProgramTree tree();

  /** What the program can refer to. */
  Installation installation();

  /** The newest snapshot. */
  ControllerState state();

  /**
   * Replaces the program.
   *
   * @param what was done, for the undo menu, such as {@code Change speed}; changes of the same node
   *     with the same words within a short time are undone together
   */
  void change(String what, ProgramTree next);

  /** How people read and type poses. */
  default PoseForm poseForm() {
    return PoseForm.STANDARD;
  }

  /** Where the program's file is; empty while it has none. */
  default Optional<Path> folder() {
    return Optional.empty();
  }

  /** What keeps a node from running. */
  List<NodeProblem> problems(long key);

  /** What the script of a node is warned of, which keeps it from nothing. */
  List<NodeProblem> warnings(long key);

  /** Brings a node into view and selects it. */
  void select(long key);

  /** Goes to the Move screen to teach a waypoint; a strip there accepts or leaves. */
  void teach(String waypoint);

  /** Has the arm go to a taught waypoint for as long as the caller holds. */
  void holdToGo(String waypoint);

  /** Ends {@link #holdToGo}. */
  void release();

  /** Tells something at the edge of the window. */
  void notify(String text);
}
