package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.awt.BorderLayout;
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
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.kit.table.RowsModel;
import org.pendant.kit.theme.HtmlLabel;
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
  private final JLabel none = new HtmlLabel();
  private transient Set<String> names = Set.of();
  private transient Optional<VariableSamples> seen = Optional.empty();
  private long seenMs;

  ValuesPane() {
    super(new BorderLayout());
    setName("program-variables-pane");
    table.setName("program-variables");
    table.getAccessibleContext().setAccessibleName(text("variablesOfTheProgram"));
    table.setFillsViewportHeight(true);
    none.setBorder(BorderFactory.createEmptyBorder(8, 10, 8, 10));
    none.setText(text("nodesGiveVariablesValues"));
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

  /** A variable and its value; a dash where it has none. */
  private record Named(String name, String value) {}

  /** Names and values. */
  private static final class Values extends RowsModel<Named> {
    Values() {
      super(List.of(text("variable"), text("value")));
    }

    void show(Set<String> names, Map<String, String> known) {
      show(
          names.stream().map(name -> new Named(name, known.getOrDefault(name, "\u2013"))).toList());
    }

    @Override
    protected Object cell(Named row, int column) {
      return column == 0 ? row.name() : row.value();
    }
  }
}
