package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.LongConsumer;
import java.util.function.LongFunction;
import java.util.function.LongSupplier;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.move.JogHold;
import org.pendant.desktop.program.form.FormHost;
import org.pendant.desktop.program.form.Taught;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.TreeNames;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.check.NodeProblem;

/** Program host: what forms use of the program in front. */
final class ProgramHost implements FormHost {
  private final Workbench workbench;
  private final ArmTeacher teacher;
  private final JogHold hold;
  private final LongConsumer select;
  private final LongSupplier selected;
  private final LongFunction<List<NodeProblem>> warnings;
  private Optional<TreeProgram> program = Optional.empty();

  /**
   * No program yet.
   *
   * @param hold moves the arm while something is held
   * @param select brings a node into view and selects it
   * @param selected the key of the node whose form is shown; 0 for none
   * @param warnings what the script of a node of the program is warned of
   */
  ProgramHost(
      Workbench workbench,
      ArmTeacher teacher,
      JogHold hold,
      LongConsumer select,
      LongSupplier selected,
      LongFunction<List<NodeProblem>> warnings) {
    this.workbench = workbench;
    this.teacher = teacher;
    this.hold = hold;
    this.select = select;
    this.selected = selected;
    this.warnings = warnings;
  }

  /** The program whose nodes are shown from now on. */
  void setProgram(Optional<TreeProgram> wanted) {
    program = wanted;
    hold.release();
  }

  @Override
  public ProgramTree tree() {
    return program.map(TreeProgram::tree).orElseGet(ProgramTree::empty);
  }

  @Override
  public Installation installation() {
    return program.map(TreeProgram::installation).orElse(Installation.NONE);
  }

  @Override
  public ControllerState state() {
    return workbench.session().state();
  }

  @Override
  public void change(String what, ProgramTree next) {
    program.ifPresent(each -> each.change(what, selected.getAsLong(), next));
  }

  @Override
  public PoseForm poseForm() {
    return FormMemory.read(workbench.settings());
  }

  @Override
  public Optional<Path> folder() {
    return program
        .flatMap(each -> each.document().file())
        .map(file -> file.toAbsolutePath().getParent());
  }

  @Override
  public List<NodeProblem> problems(long key) {
    return program.map(each -> each.problems(key)).orElse(List.of());
  }

  @Override
  public List<NodeProblem> warnings(long key) {
    return warnings.apply(key);
  }

  @Override
  public void select(long key) {
    select.accept(key);
  }

  @Override
  public void teach(String waypoint) {
    Optional<TreeProgram> taught = program;
    teacher.teach(
        waypoint,
        () -> {
          taught.ifPresent(each -> setHere(each, waypoint));
          workbench.show(ProgramView.ID);
        },
        () -> workbench.show(ProgramView.ID));
  }

  private void setHere(TreeProgram of, String waypoint) {
    WaypointPosition here = Taught.here(state(), of.installation(), feature(of.tree(), waypoint));
    of.change(text("teachWaypoint", waypoint), 0, of.tree().withWaypoint(waypoint, here));
  }

  /** In what a place is taught: as the first node says that goes there. */
  private static String feature(ProgramTree tree, String waypoint) {
    return tree.nodes().stream()
        .filter(node -> TreeNames.waypoints(node.step()).contains(waypoint))
        .flatMap(node -> feature(tree, node).stream())
        .findFirst()
        .orElse(WaypointPosition.BASE);
  }

  private static Optional<String> feature(ProgramTree tree, ProgramNode node) {
    Optional<ProgramNode> each = Optional.of(node);
    while (each.isPresent()) {
      Optional<String> own =
          switch (each.get().step()) {
            case MotionStep.Move move -> Optional.of(move.feature());
            case TemplateStep.Palletizing pallet -> Optional.of(pallet.feature());
            case TemplateStep.Seek seek -> Optional.of(seek.feature());
            default -> Optional.empty();
          };
      if (own.isPresent()) {
        return own;
      }
      each = tree.parentOf(each.get().key()).flatMap(tree::find);
    }
    return Optional.empty();
  }

  @Override
  public void holdToGo(String waypoint) {
    WaypointPosition place = tree().waypoints().get(waypoint);
    if (place == null) {
      notify(text("wasNeverTaught", waypoint));
    } else {
      hold.press(new JogMove.ToJoints(place.jointsRad()), 1);
    }
  }

  @Override
  public void release() {
    if (!hold.reason().isEmpty()) {
      notify(text("theArmHasStopped", hold.reason()));
    }
    hold.release();
  }

  /** Time goes by: what is held continues. */
  void repeat() {
    hold.repeat();
  }

  @Override
  public void notify(String text) {
    workbench.notify(text);
  }
}
