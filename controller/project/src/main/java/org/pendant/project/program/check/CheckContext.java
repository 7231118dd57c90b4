package org.pendant.project.program.check;

import static org.pendant.project.program.check.ProgramCheckTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.Installation;
import org.pendant.language.signature.Catalogue;
import org.pendant.project.program.Identifiers;
import org.pendant.project.program.NodeField;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.WaypointPosition;

/**
 * Check context: what has been found out about a tree so far, and the questions that many nodes ask
 * about it.
 */
final class CheckContext {
  private final ProgramTree tree;
  private final Installation installation;
  private final Catalogue catalogue;
  private final List<NodeProblem> problems = new ArrayList<>();
  private final List<TypedText> expressions = new ArrayList<>();
  private final Map<String, Optional<String>> nameRefusals = new LinkedHashMap<>();
  private final Set<String> subPrograms = new HashSet<>();

  /**
   * An expression as it was typed.
   *
   * @param field of the node with that key
   */
  record TypedText(long key, String field, String text) {}

  CheckContext(ProgramTree tree, Installation installation, Catalogue catalogue) {
    this.tree = tree;
    this.installation = installation;
    this.catalogue = catalogue;
    for (ProgramNode section : tree.sections()) {
      if (section.step() instanceof Section.SubProgram(String name, String file)
          && !section.suppressed()) {
        subPrograms.add(name);
      }
    }
  }

  ProgramTree tree() {
    return tree;
  }

  Installation installation() {
    return installation;
  }

  /** What was found, in no particular order. */
  List<NodeProblem> problems() {
    return problems;
  }

  /** All expressions of nodes that run. */
  List<TypedText> expressions() {
    return expressions;
  }

  /** The names of all sub programs that run. */
  Set<String> subPrograms() {
    return subPrograms;
  }

  void problem(ProgramNode node, String field, String message) {
    problems.add(new NodeProblem(node.key(), field, message));
  }

  void problem(long key, String field, String message) {
    problems.add(new NodeProblem(key, field, message));
  }

  void remark(ProgramNode node, String message) {
    remark(node.key(), message);
  }

  void remark(long key, String message) {
    problems.add(new NodeProblem(key, "", message, false));
  }

  /** An expression; {@code what} is what it is in the sentence "the ... is missing". */
  void expression(ProgramNode node, String field, String what, String text) {
    if (text.isBlank()) {
      problem(node, field, text("expressionMissing", what));
    } else {
      expressions.add(new TypedText(node.key(), field, text));
    }
  }

  /** A number of a node, in SI. */
  void number(ProgramNode node, NodeField field, double value) {
    field
        .refusal(value)
        .ifPresent(
            legal ->
                problem(
                    node,
                    field.component(),
                    text("numberRefused", field.words(), field.unit().words(value), legal)));
  }

  /** A number of a node, in SI, that there need not be. */
  void number(ProgramNode node, NodeField field, OptionalDouble value) {
    value.ifPresent(number -> number(node, field, number));
  }

  /** A name that becomes a variable or function of the script. */
  void identifier(ProgramNode node, String field, String what, String name) {
    if (name.isBlank()) {
      problem(node, field, text("noName", what));
      return;
    }
    nameRefusals
        .computeIfAbsent(name, this::refusal)
        .ifPresent(reason -> problem(node, field, reason));
  }

  private Optional<String> refusal(String name) {
    Optional<String> noIdentifier = Identifiers.refusal(name);
    if (noIdentifier.isPresent()) {
      return noIdentifier;
    }
    if (catalogue.function(name).isPresent()) {
      return Optional.of(text("nameOfFunction", name));
    }
    if (subPrograms.contains(name)) {
      return Optional.of(text("nameOfSubProgram", name));
    }
    return installation.feature(name).isPresent()
        ? Optional.of(text("nameOfFeature", name))
        : Optional.empty();
  }

  /** A place that must have been taught. */
  Optional<WaypointPosition> taught(ProgramNode node, String field, String name) {
    if (name.isBlank()) {
      problem(node, field, text("waypointWithoutName"));
      return Optional.empty();
    }
    Optional<WaypointPosition> position = Optional.ofNullable(tree.waypoints().get(name));
    if (position.isEmpty()) {
      problem(node, field, text("notTaught", name));
    } else {
      feature(node, field, position.get().feature());
    }
    return position;
  }

  /** Base, tool or a finished feature of the installation. */
  void feature(ProgramNode node, String field, String name) {
    if (name.equals(WaypointPosition.BASE) || name.equals(WaypointPosition.TOOL)) {
      return;
    }
    Optional<Feature> feature = installation.feature(name);
    if (name.isBlank()) {
      problem(node, field, text("featureMissing"));
    } else if (feature.isEmpty()) {
      problem(node, field, text("noSuchFeature", name));
    } else if (feature.get().points().size() < feature.get().kind().points()) {
      problem(node, field, text("featureIncomplete", name));
    }
  }

  void tool(ProgramNode node, String field, ToolChoice choice) {
    switch (choice) {
      case ToolChoice.Active _ -> {}
      case ToolChoice.Flange _ -> {}
      case ToolChoice.Named named -> namedTool(node, field, named.name());
    }
  }

  void namedTool(ProgramNode node, String field, String name) {
    if (installation.tool(name).isEmpty()) {
      problem(node, field, name.isBlank() ? text("tcpMissing") : text("noSuchTcp", name));
    }
  }
}
