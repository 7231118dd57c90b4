package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.models.arm.JointLimits;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.NumberRange;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Step;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.WaypointPosition;

/**
 * Form context: what the form of one node is made from.
 *
 * @param tree as it was when the form was made; the form is made anew when it changes
 * @param files reads and chooses files
 */
record FormContext(FormHost host, ProgramTree tree, ProgramNode node, Kept kept, FormFiles files) {
  Installation installation() {
    return host.installation();
  }

  long key() {
    return node.key();
  }

  /** The program with another step in this node. */
  ProgramTree with(Step step) {
    return tree.withStep(key(), step);
  }

  /** The signals that can be chosen. */
  SignalChoices signals() {
    return new SignalChoices(installation());
  }

  /** The nearest node above of a kind of step. */
  <S extends Step> Optional<S> above(Class<S> type) {
    Optional<ProgramNode> at = parent(key());
    while (at.isPresent() && !type.isInstance(at.get().step())) {
      at = parent(at.get().key());
    }
    return at.map(ProgramNode::step).map(type::cast);
  }

  private Optional<ProgramNode> parent(long of) {
    return tree.parentOf(of).flatMap(tree::find);
  }

  /** The kind of the move that this node belongs to. */
  MoveKind moveKind() {
    return above(MotionStep.Move.class).map(MotionStep.Move::kind).orElse(MoveKind.LINEAR);
  }

  /** How fast a move may be, as far as this arm goes. */
  NumberRange usualSpeed(MoveKind kind) {
    NumberRange legal = NodeFields.speed(kind).range();
    double fastest =
        host.state().arm().description().joints().stream()
            .mapToDouble(JointLimits::maxSpeedRadPerS)
            .max()
            .orElse(legal.max());
    return kind == MoveKind.JOINT ? NumberRange.upTo(Math.min(fastest, legal.max())) : legal;
  }

  /** The feature of the move that this node belongs to. */
  String moveFeature() {
    return above(MotionStep.Move.class).map(MotionStep.Move::feature).orElse(WaypointPosition.BASE);
  }

  /** The feature in which places of this node are taught. */
  String teachFeature() {
    Optional<ProgramNode> at = Optional.of(node);
    while (at.isPresent()) {
      Step step = at.get().step();
      if (step instanceof MotionStep.Move move) {
        return move.feature();
      } else if (step instanceof TemplateStep.Palletizing pallet) {
        return pallet.feature();
      } else if (step instanceof TemplateStep.Seek seek) {
        return seek.feature();
      }
      at = parent(at.get().key());
    }
    return WaypointPosition.BASE;
  }

  /** The features that there are. */
  List<Option> features() {
    return options(
        List.of(
            new Option(WaypointPosition.BASE, text("base")),
            new Option(WaypointPosition.TOOL, text("tool"))),
        installation().features(),
        each -> each.name());
  }

  /** How people read the name of a feature. */
  static String shown(String feature) {
    return switch (feature) {
      case WaypointPosition.BASE -> text("base");
      case WaypointPosition.TOOL -> text("tool");
      default -> feature;
    };
  }

  /** Options for things with names, behind some others. */
  static <T> List<Option> options(List<Option> first, List<T> things, Function<T, String> name) {
    List<Option> all = new ArrayList<>(first);
    things.forEach(each -> all.add(new Option(name.apply(each), name.apply(each))));
    return List.copyOf(all);
  }

  /** Options that read as their values do. */
  static List<Option> plain(List<String> names) {
    return names.stream().map(each -> new Option(each, each)).toList();
  }

  /** Does something as one step of undo. */
  void change(String what, ProgramTree next) {
    host.change(what, next);
  }
}
