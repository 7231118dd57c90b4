package org.pendant.project.program.check;

import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.language.check.Checker;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.project.program.ExternalControl;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.TreeNames;
import org.pendant.project.program.check.CheckContext.TypedText;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.ScriptGenerator;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.ProgramLoader;

/**
 * Script check: finds what shows only in the script of the whole tree, such as variables that
 * nothing assigns and script lines that do not fit together.
 */
final class ScriptCheck {
  private static final String PROGRAM = "program";
  private static final String UNKNOWN_FUNCTION = "unknown-function";
  private static final String UNKNOWN_VARIABLE = "unknown-variable";
  private static final String UNASSIGNED_VARIABLE = "unassigned-variable";

  private final CheckContext findings;
  private final Builtins<?> builtins;

  ScriptCheck(CheckContext findings, Builtins<?> builtins) {
    this.findings = findings;
    this.builtins = builtins;
  }

  /**
   * Reports what is wrong with the script, apart from what follows from problems that are known;
   * nodes that have one are left out.
   */
  void check() {
    Set<Long> unfinished = new HashSet<>();
    findings.problems().stream()
        .filter(NodeProblem::blocks)
        .forEach(each -> unfinished.add(each.key()));
    ProgramTree tree = findings.tree();
    GeneratedScript script =
        ScriptGenerator.generate(
            PROGRAM,
            unfinished.isEmpty() ? tree : without(tree, unfinished),
            findings.installation());
    Source source = Source.of(PROGRAM, script.text());
    List<Diagnostic> errors =
        ProgramLoader.load(source, builtins).diagnostics().stream()
            .filter(Checker::fails)
            .sorted(Comparator.comparing(Diagnostic::isError).reversed())
            .toList();
    if (errors.isEmpty()) {
      return;
    }
    // names may be those of a script that is not here before the program starts
    boolean asks = ExternalControl.count(tree) > 0;
    Set<String> assigned = unfinished.isEmpty() ? Set.of() : TreeNames.all(tree);
    Map<Long, Diagnostic> first = new HashMap<>();
    for (Diagnostic error : errors) {
      long key = key(script, source.line(error.range().start()));
      boolean follows =
          unfinished.contains(key)
              || (asks && isAboutAName(error))
              || (isAboutAVariable(error) && assigned.contains(source.text(error.range())));
      if (!follows && first.putIfAbsent(key, error) == null) {
        report(key, error, source);
      }
    }
  }

  private static ProgramTree without(ProgramTree tree, Set<Long> keys) {
    return new ProgramTree(
        tree.installation(), tree.waypoints(), without(tree.sections(), keys), tree.nextKey());
  }

  private static List<ProgramNode> without(List<ProgramNode> nodes, Set<Long> keys) {
    return nodes.stream()
        .map(
            each ->
                each.withSuppressed(each.suppressed() || keys.contains(each.key()))
                    .withChildren(without(each.children(), keys)))
        .toList();
  }

  private static boolean isAboutAVariable(Diagnostic error) {
    return error.code().equals(UNKNOWN_VARIABLE) || error.code().equals(UNASSIGNED_VARIABLE);
  }

  private static boolean isAboutAName(Diagnostic error) {
    return isAboutAVariable(error) || error.code().equals(UNKNOWN_FUNCTION);
  }

  /** The node that a line belongs to, or the main program. */
  private long key(GeneratedScript script, int line) {
    return script
        .at(line)
        .map(GeneratedScript.NodeLines::key)
        .or(
            () ->
                findings.tree().sections().stream()
                    .filter(each -> each.step() instanceof Section.MainProgram)
                    .map(ProgramNode::key)
                    .findFirst())
        .orElse(ProgramTree.ROOT);
  }

  private void report(long key, Diagnostic error, Source source) {
    int line = source.line(error.range().start());
    String text = source.lineText(line);
    int offset = source.column(error.range().start()) - 1;
    for (TypedText each : findings.expressions()) {
      if (each.key() == key) {
        Optional<Integer> within = within(text, ByteText.asBytes(each.text()), offset);
        if (within.isPresent()) {
          String bytes = ByteText.asBytes(each.text());
          findings.problem(
              key,
              each.field(),
              ExpressionValidator.located(each.text(), bytes, within.get(), error.message()));
          return;
        }
      }
    }
    String message = ByteText.decoded(error.message());
    if (error.isError()) {
      findings.problem(key, "", message);
    } else {
      // the script of a node may have parts that never run
      findings.remark(key, message);
    }
  }

  /** Where in an expression a place of a line is that holds it. */
  private static Optional<Integer> within(String line, String expression, int offset) {
    for (int at = line.indexOf(expression); at >= 0; at = line.indexOf(expression, at + 1)) {
      if (at <= offset && offset <= at + expression.length()) {
        return Optional.of(offset - at);
      }
    }
    return Optional.empty();
  }
}
