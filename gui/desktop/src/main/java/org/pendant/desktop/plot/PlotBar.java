package org.pendant.desktop.plot;

import java.util.List;
import java.util.Locale;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import org.pendant.kit.layout.WrappingRow;

/** Plot bar: pause, time span, cursors and export, above the charts. */
final class PlotBar {
  private static final List<Double> WIDTHS_S = List.of(5.0, 10.0, 30.0, 60.0, 120.0, 300.0, 600.0);

  private final PlotPresenter presenter;
  private final JPanel bar = new JPanel(new WrappingRow(8));
  private final JToggleButton pause = new JToggleButton(PlotTexts.text("pause"));
  private final JToggleButton cursors = new JToggleButton(PlotTexts.text("cursors"));
  private final JComboBox<String> width = new JComboBox<>();
  private final JLabel readout = new JLabel();
  private boolean showing;

  PlotBar(PlotPresenter presenter, Runnable changed, Runnable export) {
    this.presenter = presenter;
    bar.setName("plot-bar");
    add(pause, "plot-pause", PlotTexts.text("pauseTheChartsRecordingContinuesSpace"));
    pause.addActionListener(
        event -> {
          presenter.pause(pause.isSelected());
          changed.run();
        });
    addWidths(changed);
    add(cursors, "plot-cursors", PlotTexts.text("pauseTheChartsAndReadValues"));
    cursors.addActionListener(
        event -> {
          presenter.showCursors(cursors.isSelected());
          changed.run();
        });
    JButton save = new JButton(PlotTexts.text("export"));
    add(save, "plot-export", PlotTexts.text("saveWhatTheChartsShowTo"));
    save.addActionListener(event -> export.run());
    readout.setName("plot-readout");
    readout.setToolTipText(PlotTexts.text("timesOfTheCursors"));
    readout.putClientProperty("FlatLaf.styleClass", "monospaced");
    bar.add(readout);
    refresh();
  }

  private void addWidths(Runnable changed) {
    WIDTHS_S.forEach(seconds -> width.addItem(text(seconds)));
    width.setEditable(false);
    name(width, "plot-width", PlotTexts.text("howMuchTimeTheChartsShow"));
    width.addActionListener(
        event -> {
          int index = width.getSelectedIndex();
          if (!showing && index >= 0 && index < WIDTHS_S.size()) {
            presenter.setWindow(presenter.window().withWidth(WIDTHS_S.get(index)));
            changed.run();
          }
        });
    bar.add(width);
  }

  private void add(AbstractButton button, String name, String tip) {
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    name(button, name, tip);
    bar.add(button);
  }

  private static void name(JComponent component, String name, String tip) {
    component.setName(name);
    component.setToolTipText(tip);
    component.getAccessibleContext().setAccessibleName(tip);
  }

  /** A length of time as people say it. */
  static String text(double seconds) {
    boolean minutes = seconds >= 60 && seconds % 60 == 0;
    double number = minutes ? seconds / 60 : seconds;
    String digits =
        number == Math.rint(number)
            ? Long.toString(Math.round(number))
            : String.format(Locale.ROOT, "%.2f", number);
    return digits + (minutes ? " min" : " s");
  }

  JComponent component() {
    return bar;
  }

  /** Shows what the presenter says. */
  void refresh() {
    showing = true;
    pause.setSelected(presenter.paused());
    pause.setText(presenter.paused() ? PlotTexts.text("resume") : PlotTexts.text("pause"));
    cursors.setSelected(presenter.cursors().isPresent());
    showWidth(text(presenter.window().widthS()));
    String times = presenter.cursors().map(Cursors::text).orElse("");
    if (!times.equals(readout.getText())) {
      readout.setText(times);
    }
    showing = false;
  }

  /** Zooming gives other widths than those on the list: such a one stands at its end. */
  private void showWidth(String text) {
    int known = WIDTHS_S.stream().map(PlotBar::text).toList().indexOf(text);
    if (known >= 0) {
      while (width.getItemCount() > WIDTHS_S.size()) {
        width.removeItemAt(WIDTHS_S.size());
      }
      if (width.getSelectedIndex() != known) {
        width.setSelectedIndex(known);
      }
    } else if (!text.equals(width.getSelectedItem())) {
      if (width.getItemCount() > WIDTHS_S.size()) {
        width.removeItemAt(WIDTHS_S.size());
      }
      width.addItem(text);
      width.setSelectedIndex(WIDTHS_S.size());
    }
  }
}
