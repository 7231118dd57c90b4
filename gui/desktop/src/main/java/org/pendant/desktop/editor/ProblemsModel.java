package org.pendant.desktop.editor;

import java.util.List;
import javax.swing.table.AbstractTableModel;
import org.pendant.desktop.editor.text.Problem;

/** Problems model: problems as rows: severity, line, message, code. */
@SuppressWarnings("serial") // never written to a stream
final class ProblemsModel extends AbstractTableModel {
  private static final List<String> TITLES = List.of("", "Line", "Problem", "Code");

  private List<Problem> problems = List.of();

  void set(List<Problem> wanted) {
    problems = wanted;
    fireTableDataChanged();
  }

  Problem at(int row) {
    return problems.get(row);
  }

  @Override
  public int getRowCount() {
    return problems.size();
  }

  @Override
  public int getColumnCount() {
    return TITLES.size();
  }

  @Override
  public String getColumnName(int column) {
    return TITLES.get(column);
  }

  @Override
  public Class<?> getColumnClass(int column) {
    return column == 1 ? Integer.class : String.class;
  }

  @Override
  public Object getValueAt(int row, int column) {
    Problem problem = problems.get(row);
    return switch (column) {
      case 0 -> problem.isError() ? "Error" : "Warning";
      case 1 -> problem.line();
      case 2 -> problem.message();
      default -> problem.diagnostic().code();
    };
  }
}
