package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.util.List;
import org.pendant.desktop.editor.text.Problem;
import org.pendant.kit.table.RowsModel;

/** Problems model: problems as rows: severity, line, message, code. */
@SuppressWarnings("serial") // never written to a stream
final class ProblemsModel extends RowsModel<Problem> {
  private static final List<String> TITLES =
      List.of("", text("line"), text("problem"), text("code"));

  ProblemsModel() {
    super(TITLES);
  }

  @Override
  public Class<?> getColumnClass(int column) {
    return column == 1 ? Integer.class : String.class;
  }

  @Override
  protected Object cell(Problem problem, int column) {
    return switch (column) {
      case 0 -> problem.isError() ? text("error") : text("warning");
      case 1 -> problem.line();
      case 2 -> problem.message();
      default -> problem.diagnostic().code();
    };
  }
}
