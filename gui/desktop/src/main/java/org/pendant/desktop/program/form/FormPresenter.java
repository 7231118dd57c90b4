package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.function.Function;
import org.pendant.controller.installation.Installation;
import org.pendant.kit.text.Messages;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.check.NodeProblem;
import org.pendant.text.Language;

/**
 * Form presenter: what is shown of the selected node, and what becomes of what people type. One
 * thread uses it, the dispatch thread.
 */
final class FormPresenter {
  private final FormHost host;
  private final FormFiles files;
  private final Kept kept = new Kept();
  private OptionalLong key = OptionalLong.empty();
  private Optional<NodeForm> form = Optional.empty();
  private Optional<Basis> basis = Optional.empty();

  /** What a form has been made from. */
  private record Basis(ProgramTree tree, Installation installation) {}

  /** Nothing is selected. */
  FormPresenter(FormHost host, FormFiles files) {
    this.host = host;
    this.files = files;
  }

  /** Another node is selected, or none. */
  void select(Optional<ProgramNode> node) {
    OptionalLong wanted =
        node.map(each -> OptionalLong.of(each.key())).orElseGet(OptionalLong::empty);
    if (!wanted.equals(key)) {
      key = wanted;
      kept.clear();
    }
    basis = Optional.empty();
  }

  /** Which node is selected. */
  OptionalLong key() {
    return key;
  }

  /** The form of the selected node as it is now; empty if there is none. */
  @SuppressWarnings("ReferenceEquality") // what is the same object has not changed
  Optional<NodeForm> form() {
    boolean same =
        basis
            .filter(each -> each.tree() == host.tree())
            .filter(each -> each.installation() == host.installation())
            .isPresent();
    if (!same) {
      ProgramTree tree = host.tree();
      basis = Optional.of(new Basis(tree, host.installation()));
      form = node().map(node -> StepForms.of(new FormContext(host, tree, node, kept, files)));
    }
    return form;
  }

  private Optional<ProgramNode> node() {
    return key.isPresent() ? host.tree().find(key.getAsLong()) : Optional.empty();
  }

  /** Whether the selected node generates nothing because it is suppressed itself. */
  boolean suppressed() {
    return node().map(ProgramNode::suppressed).orElse(false);
  }

  /** Has a suppressed node take part again. */
  void useAgain() {
    node()
        .ifPresent(
            node ->
                change(
                    text("useAgain"),
                    host.tree().withNode(node.key(), each -> each.withSuppressed(false))));
  }

  private <I extends Item> Optional<I> item(String name, Class<I> type) {
    return form().flatMap(each -> each.item(name)).filter(type::isInstance).map(type::cast);
  }

  @SuppressWarnings("ReferenceEquality") // what is the same object has not changed
  private void change(String what, ProgramTree next) {
    if (next != host.tree() && !next.equals(host.tree())) {
      host.change(what, next);
    }
  }

  private void change(Item item, ProgramTree next) {
    change(
        item.label().isEmpty()
            ? text("changeNode")
            : text("change", Language.ofProcess().withinSentence(item.label())),
        next);
  }

  /**
   * Takes what was typed as a number.
   *
   * @return why it cannot be taken; empty if it is
   */
  String typeNumber(String name, String typed) {
    Optional<Item.Quantity> found = item(name, Item.Quantity.class);
    if (found.isEmpty() || found.get().text().equals(typed.strip())) {
      return "";
    }
    Item.Quantity number = found.get();
    if (typed.isBlank() && !number.whenEmpty().isEmpty()) {
      change(number, number.edit().apply(OptionalDouble.empty()));
      return "";
    }
    double value;
    try {
      value = number.parse(typed);
    } catch (IllegalArgumentException refused) {
      return Messages.shown(refused.getMessage());
    }
    String refusal = number.refusal(value);
    if (refusal.isEmpty()) {
      change(number, number.edit().apply(OptionalDouble.of(value)));
    }
    return refusal;
  }

  /**
   * Takes a text.
   *
   * @return why it cannot be taken; empty if it is
   */
  String typeText(String name, String typed) {
    Optional<Item> found = form().flatMap(each -> each.item(name));
    return found.map(item -> typeText(item, typed)).orElse("");
  }

  private String typeText(Item item, String typed) {
    return switch (item) {
      case Item.Text text -> {
        String refusal = text.refusal().apply(typed);
        if (refusal.isEmpty()) {
          replace(item, text.value(), typed, text.edit());
        }
        yield refusal;
      }
      case Item.Expression expression ->
          replace(item, expression.value(), typed, expression.edit());
      case Item.Prose prose -> replace(item, prose.value(), typed, prose.edit());
      case Item.Code code ->
          code.edit().map(edit -> replace(item, code.value(), typed, edit)).orElse("");
      case Item.Quantity _,
          Item.Choice _,
          Item.Check _,
          Item.Presses _,
          Item.Note _,
          Item.Drawing _,
          Item.Grid _,
          Item.Line _ ->
          throw new IllegalArgumentException(item.name() + " holds no text");
    };
  }

  private String replace(Item item, String was, String typed, Function<String, ProgramTree> edit) {
    if (!was.equals(typed)) {
      change(item, edit.apply(typed));
    }
    return "";
  }

  /** Takes what was chosen. */
  void choose(String name, String value) {
    item(name, Item.Choice.class)
        .filter(choice -> !choice.value().equals(value))
        .ifPresent(choice -> change(choice, choice.edit().apply(value)));
  }

  /** Checks or unchecks. */
  void check(String name, boolean value) {
    item(name, Item.Check.class)
        .filter(check -> check.value() != value)
        .ifPresent(check -> change(check, check.edit().apply(value)));
  }

  /** What is wrong at an item, as far as it was found by checking the program. */
  String problem(NodeForm shown, String name) {
    if (key.isEmpty()) {
      return "";
    }
    String own = shown.item(name).map(FormPresenter::ownProblem).orElse("");
    if (!own.isEmpty()) {
      return own;
    }
    return host.problems(key.getAsLong()).stream()
        .filter(each -> at(shown, each).filter(name::equals).isPresent())
        .map(each -> Messages.shown(each.message()))
        .findFirst()
        .orElse("");
  }

  /** Why the value that an item has, from a file for instance, could not be typed. */
  private static String ownProblem(Item item) {
    return switch (item) {
      case Item.Text text -> text.value().isEmpty() ? "" : text.refusal().apply(text.value());
      case Item.Quantity number ->
          number.value().isPresent() ? number.refusal(number.value().getAsDouble()) : "";
      case Item.Expression _,
          Item.Prose _,
          Item.Code _,
          Item.Choice _,
          Item.Check _,
          Item.Presses _,
          Item.Note _,
          Item.Drawing _,
          Item.Grid _,
          Item.Line _ ->
          "";
    };
  }

  private static Optional<String> at(NodeForm shown, NodeProblem problem) {
    return problem.field().isEmpty()
        ? Optional.empty()
        : shown.itemFor(problem.field()).map(Item::name);
  }

  /** What is wrong with the node as a whole, or where the form has no field. */
  List<String> problems(NodeForm shown) {
    List<String> messages = new ArrayList<>();
    if (key.isPresent()) {
      for (NodeProblem each : host.problems(key.getAsLong())) {
        String message = Messages.shown(each.message());
        if (at(shown, each).isEmpty() && !messages.contains(message)) {
          messages.add(message);
        }
      }
    }
    return messages;
  }

  /** What the script of the node is warned of. */
  List<String> warnings() {
    return key.isEmpty()
        ? List.of()
        : host.warnings(key.getAsLong()).stream().map(NodeProblem::message).distinct().toList();
  }

  /** Where expressions are read. */
  ExpressionScope scope() {
    return ExpressionScope.of(host.tree(), host.installation());
  }
}
