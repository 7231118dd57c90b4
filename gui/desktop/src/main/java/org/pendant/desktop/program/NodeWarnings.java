package org.pendant.desktop.program;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.desktop.editor.ScriptEditor;
import org.pendant.desktop.editor.text.Problem;
import org.pendant.kit.text.Messages;
import org.pendant.project.program.check.NodeProblem;
import org.pendant.project.program.script.GeneratedScript;

/**
 * Node warnings: what the check of the script that a tree generates warns of, at the nodes that the
 * lines come from. They keep no program from running.
 */
final class NodeWarnings {
  private final ScriptEditor editor;
  private List<Problem> seen = List.of();
  private GeneratedScript script = GeneratedScript.EMPTY;
  private Map<Long, List<NodeProblem>> warnings = Map.of();

  /** Those of the scripts that {@code editor} checks. */
  NodeWarnings(ScriptEditor editor) {
    this.editor = editor;
  }

  /** By the keys of the nodes; the same object while nothing changes. */
  Map<Long, List<NodeProblem>> of(TreeProgram program) {
    Optional<List<Problem>> now = editor.problems(program.document());
    // While the script is checked again, what was known stays.
    boolean same = now.isEmpty() || now.get().equals(seen);
    if (same && program.script().equals(script)) {
      return warnings;
    }
    if (now.isEmpty()) {
      return Map.of();
    }
    seen = now.get();
    script = program.script();
    Map<Long, List<NodeProblem>> found = new HashMap<>();
    List<String> lines = script.text().lines().toList();
    for (Problem each : seen) {
      long key = each.isError() ? 0 : key(program, lines, each.line());
      if (key != 0) {
        found
            .computeIfAbsent(key, _ -> new ArrayList<>())
            .add(new NodeProblem(key, "", Messages.shown(each.message()), false));
      }
    }
    warnings = found;
    return warnings;
  }

  /**
   * The node of a line; 0 for none. Where a node begins with what never stops a program, such as
   * the head of an endless loop, its label above says which it is.
   */
  private long key(TreeProgram program, List<String> lines, int line) {
    long labelled = ScriptLink.labelled(program, line > 1 ? lines.get(line - 2) : "");
    return labelled != 0 ? labelled : ScriptLink.key(script, line);
  }

  /** What keeps a program from running, and its warnings behind that, by node. */
  Map<Long, List<NodeProblem>> with(TreeProgram program) {
    Map<Long, List<NodeProblem>> all = new HashMap<>();
    program.problems().forEach(each -> all.put(each.key(), program.problems(each.key())));
    of(program)
        .forEach(
            (key, warned) -> {
              List<NodeProblem> both = new ArrayList<>(all.getOrDefault(key, List.of()));
              both.addAll(warned);
              all.put(key, both);
            });
    return all;
  }
}
