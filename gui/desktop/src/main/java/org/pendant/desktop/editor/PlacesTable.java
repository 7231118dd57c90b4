package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.Component;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.table.DefaultTableCellRenderer;
import org.pendant.desktop.editor.text.Place;
import org.pendant.kit.table.RowsModel;
import org.pendant.kit.table.TableLook;
import org.pendant.kit.theme.Markup;

/** Places table: places in programs, one a row; ENTER or a double click opens one. */
@SuppressWarnings("serial") // never written to a stream
final class PlacesTable extends JTable {
  private final Model model;

  PlacesTable(Consumer<Place> chosen) {
    this(new Model(), chosen);
  }

  private PlacesTable(Model model, Consumer<Place> chosen) {
    super(model);
    this.model = model;
    TableLook.apply(this, "places-table", text("placesFound"));
    getColumnModel().getColumn(0).setPreferredWidth(200);
    getColumnModel().getColumn(0).setMaxWidth(360);
    getColumnModel().getColumn(1).setPreferredWidth(800);
    getColumnModel().getColumn(1).setCellRenderer(new Code());
    Runnable choose =
        () -> {
          if (getSelectedRow() >= 0) {
            chosen.accept(model.row(getSelectedRow()));
          }
        };
    registerKeyboardAction(
        event -> choose.run(),
        KeyStroke.getKeyStroke("ENTER"),
        JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
    addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            if (event.getClickCount() == 2) {
              choose.run();
            }
          }
        });
  }

  void set(List<Place> places) {
    model.replace(places);
    if (!places.isEmpty()) {
      setRowSelectionInterval(0, 0);
    }
  }

  void add(List<Place> places) {
    model.show(Stream.concat(model.rows().stream(), places.stream()).toList());
  }

  /** The line with what was found in bold, cut where it is too long. */
  static String marked(Place place) {
    String line = place.text();
    int from = Math.clamp(place.column() - 1, 0, line.length());
    int to = Math.clamp((long) from + place.length(), from, line.length());
    int first = Math.max(0, from - 60);
    int last = Math.min(line.length(), to + 120);
    return "<html><nobr>"
        + (first > 0 ? "\u2026" : "")
        + escaped(line.substring(first, from).stripLeading())
        + "<b><u>"
        + escaped(line.substring(from, to))
        + "</u></b>"
        + escaped(line.substring(to, last))
        + (last < line.length() ? "\u2026" : "");
  }

  private static String escaped(String text) {
    return Markup.escaped(text).replace(" ", "&nbsp;");
  }

  /** The rows. */
  private static final class Model extends RowsModel<Place> {
    Model() {
      super(List.of(text("place"), text("line")));
    }

    @Override
    protected Object cell(Place place, int column) {
      return column == 0 ? place.name() + ":" + place.line() : place;
    }
  }

  /** A line of code. */
  private static final class Code extends DefaultTableCellRenderer {
    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean selected, boolean focused, int row, int column) {
      super.getTableCellRendererComponent(table, value, selected, false, row, column);
      setFont(EditorTheme.codeFont());
      setText(value instanceof Place place ? marked(place) : "");
      setForeground(selected ? table.getSelectionForeground() : table.getForeground());
      return this;
    }
  }
}
