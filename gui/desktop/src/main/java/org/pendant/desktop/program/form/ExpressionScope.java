package org.pendant.desktop.program.form;

import java.util.List;
import org.pendant.controller.installation.Installation;
import org.pendant.language.source.Source;
import org.pendant.project.program.ProgramTree;

/**
 * Expression scope: a program in which expressions of a tree are read while they are typed: it
 * knows the names of the tree and of the installation, and nothing of their values.
 *
 * @param line before which expressions stand, from 1
 */
record ExpressionScope(String text, int line) {
  /** Knows no names. */
  static final ExpressionScope NONE = new ExpressionScope("", 1);

  /** Stands for whatever a function of the program gives. */
  static final String ANYTHING = "any_value";

  /** The program as it is read. */
  Source source() {
    return Source.of("expressions", text);
  }

  /** The scope of all expressions of a program. */
  static ExpressionScope of(ProgramTree tree, Installation installation) {
    List<String> functions = ProgramNames.functions(tree);
    List<String> names =
        ProgramNames.variables(tree, installation).stream()
            .filter(name -> functions.stream().noneMatch(each -> each.startsWith(name + "(")))
            .toList();
    StringBuilder text = new StringBuilder("def expressions(" + ANYTHING);
    names.forEach(name -> text.append(", ").append(name));
    text.append("):\n");
    functions.forEach(
        head -> text.append("  def ").append(head).append(":\n    return any_value\n  end\n"));
    int line = 2 + 3 * functions.size();
    return new ExpressionScope(text.append("  sync()\nend\n").toString(), line);
  }
}
