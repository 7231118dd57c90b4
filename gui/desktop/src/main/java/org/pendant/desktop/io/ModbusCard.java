package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.modbus.ModbusSignalState;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/** Modbus card: the signals at Modbus devices, of the installation and of programs. */
final class ModbusCard {
  private static final String NONE = text("signalsOfModbusDevicesAppearHere");

  private final TitledCard card = new TitledCard("modbus", text("modbus"), "[grow,fill,0::]");
  private final JLabel none = new JLabel(NONE);
  private final JPanel table =
      new JPanel(
          new MigLayout("insets 0, gap 12 2, wrap 3", "[grow, 0:180:][right, 0:100:][right]"));
  private final List<Line> lines = new ArrayList<>();
  private List<ModbusSignalState> shown = List.of();

  /** The labels of a signal. */
  private static final class Line {
    private final JLabel name = new JLabel();
    private final JLabel value = new JLabel();
    private final JLabel rate = new JLabel();
    private final JLabel status = new JLabel();
  }

  ModbusCard() {
    table.setOpaque(false);
    none.setEnabled(false);
    none.setToolTipText(NONE);
    card.add(none, "wmin 0");
    card.add(table);
  }

  JComponent component() {
    return card;
  }

  void refresh(ControllerState state) {
    if (!state.modbus().equals(shown)) {
      shown = state.modbus();
      show(ModbusRow.of(shown));
    }
    for (int i = 0; i < lines.size(); i++) {
      lines.get(i).status.setForeground(shown.get(i).valid() ? Palette.quiet() : Palette.error());
    }
  }

  private void show(List<ModbusRow> rows) {
    none.setVisible(rows.isEmpty());
    if (rows.size() != lines.size()) {
      lines.clear();
      table.removeAll();
      for (int i = 0; i < rows.size(); i++) {
        lines.add(add());
      }
      card.revalidate();
    }
    for (int i = 0; i < rows.size(); i++) {
      ModbusRow row = rows.get(i);
      Line line = lines.get(i);
      show(line.name, row.name(), Messages.told(row.name(), row.place()));
      show(line.value, row.value(), text("valueOf", row.name(), row.value()));
      show(line.rate, row.rate(), text("howOftenIsExchanged", row.name()));
      show(line.status, row.status(), row.status());
      line.name.setName("modbus-" + row.name());
      line.value.setName("modbus-" + row.name() + "-value");
      line.status.setName("modbus-" + row.name() + "-status");
    }
  }

  private Line add() {
    Line line = new Line();
    line.value.putClientProperty("FlatLaf.styleClass", "monospaced");
    table.add(line.name, "wmin 0");
    table.add(line.value, "wmin 0");
    table.add(line.rate);
    table.add(line.status, "span 3, growx, w 0:100:, gapbottom 4");
    return line;
  }

  private static void show(JLabel label, String text, String tip) {
    if (!text.equals(label.getText())) {
      label.setText(text);
    }
    label.setToolTipText(tip);
  }
}
