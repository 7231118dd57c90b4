package org.pendant.desktop.program;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.table.AbstractTableModel;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.kit.theme.Palette;
import org.pendant.language.source.ByteText;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.TreeNames;
import org.pendant.script.variables.VariableSamples;

/**
 * Values pane: the variables that the program and the installation have, with their values while it
 * runs.
 */
@SuppressWarnings("serial") // never written to a stream
final class ValuesPane extends JPanel {
  private static final long PERIOD_MS = 200;

  private final Values values = new Values();
  private final JTable table = new JTable(values);
  private final JLabel none = new JLabel();
  private transient Set<String> names = Set.of();
  private transient Optional<VariableSamples> seen = Optional.empty();
  private long seenMs;

  ValuesPane() {
    super(new BorderLayout());
    setName("program-variables-pane");
    table.setName("program-variables");
    table.getAccessibleContext().setAccessibleName("Variables of the program");
    table.setFillsViewportHeight(true);
    none.setBorder(BorderFactory.createEmptyBorder(8, 10, 8, 10));
    none.setText("<html>Nodes such as Assignment and Timer give variables a value.");
    none.setForeground(Palette.quiet());
    add(none, BorderLayout.NORTH);
    add(new JScrollPane(table));
  }

  /** Shows the variables of a program. */
  void show(ProgramTree tree, List<InstallationVariable> shared) {
    Set<String> found = new LinkedHashSet<>();
    tree.forEach(node -> found.addAll(TreeNames.variables(node.step())));
    shared.forEach(each -> found.add(each.name()));
    found.remove("");
    none.setVisible(found.isEmpty());
    if (!found.equals(names)) {
      names = found;
      seen = Optional.empty();
      values.show(names, Map.of());
    }
  }

  /** Shows values, now and then. */
  void refresh(VariableSamples samples) {
    long nowMs = System.nanoTime() / 1_000_000;
    if (nowMs - seenMs < PERIOD_MS || seen.equals(Optional.of(samples))) {
      return;
    }
    seen = Optional.of(samples);
    seenMs = nowMs;
    Map<String, String> known = new LinkedHashMap<>();
    Stream.concat(samples.globals().stream(), samples.locals().stream())
        .forEach(
            each ->
                known.put(ByteText.decoded(each.name()), ByteText.decoded(each.variable().text())));
    values.show(names, known);
  }

  /** Names and values. */
  private static final class Values extends AbstractTableModel {
    private List<String> names = List.of();
    private Map<String, String> known = Map.of();

    void show(Set<String> shown, Map<String, String> now) {
      boolean others = !List.copyOf(shown).equals(names);
      boolean changed = !now.equals(known);
      names = new ArrayList<>(shown);
      known = now;
      if (others) {
        fireTableDataChanged();
      } else if (changed && !names.isEmpty()) {
        fireTableRowsUpdated(0, names.size() - 1);
      }
    }

    @Override
    public int getRowCount() {
      return names.size();
    }

    @Override
    public int getColumnCount() {
      return 2;
    }

    @Override
    public String getColumnName(int column) {
      return column == 0 ? "Variable" : "Value";
    }

    @Override
    public Object getValueAt(int row, int column) {
      String name = names.get(row);
      return column == 0 ? name : known.getOrDefault(name, "\u2013");
    }
  }
}
