package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.DebugCommand;
import org.pendant.language.check.Nearest;
import org.pendant.script.variables.VariablePath;
import org.pendant.script.variables.VariableTracer;
import org.pendant.script.vm.Program;

/**
 * Record columns: the script variables that a record gets columns for.
 *
 * @param variables in the order of their columns
 */
record RecordColumns(List<VariablePath> variables) {
  static final Option OPTION =
      Option.text("--column", "var:NAME")
          .repeated()
          .documented(
              "var:count",
              "a column more in the record: a script variable, or an element or member of one such"
                  + " as `var:p[2]` or `var:part.size`; may be repeated");

  private static final String PREFIX = "var:";
  private static final String OWNER = "record";

  /** None besides those of every record. */
  static final RecordColumns NONE = new RecordColumns(List.of());

  RecordColumns {
    variables = List.copyOf(variables);
  }

  /**
   * The columns that were asked for.
   *
   * @throws UsageException for what is no variable, for too many, and without a record
   */
  static RecordColumns of(Arguments arguments, Optional<String> record) throws UsageException {
    List<VariablePath> paths = new ArrayList<>();
    for (String text : arguments.values(OPTION)) {
      VariablePath path = path(text);
      if (!paths.contains(path)) {
        paths.add(path);
      }
    }
    if (!paths.isEmpty() && record.isEmpty()) {
      throw new UsageException(text("columnGoesWithRecord"));
    }
    if (paths.size() > VariableTracer.MOST) {
      throw new UsageException(text("tooManyColumns", paths.size(), VariableTracer.MOST));
    }
    return new RecordColumns(paths);
  }

  private static VariablePath path(String text) throws UsageException {
    if (!text.startsWith(PREFIX)) {
      throw new UsageException(text("columnMustBe", text));
    }
    try {
      return VariablePath.of(text.substring(PREFIX.length()));
    } catch (IllegalArgumentException e) {
      throw new UsageException("--column " + text + ": " + CommandLanguage.shown(e.getMessage()));
    }
  }

  /** Refuses variables that {@code program} does not have. */
  void check(Program program) throws UsageException {
    List<String> known = program.variables();
    for (VariablePath path : variables) {
      if (!known.contains(path.name())) {
        String hint =
            new Nearest()
                .to(path.name(), () -> known)
                .map(near -> text("didYouMean", near))
                .orElse("");
        throw new UsageException(
            text("noSuchVariable", path.text(), program.name(), path.name(), hint));
      }
    }
  }

  /** Has the controller read them in every frame. */
  DebugCommand.TraceVariables command() {
    return new DebugCommand.TraceVariables(OWNER, variables);
  }
}
