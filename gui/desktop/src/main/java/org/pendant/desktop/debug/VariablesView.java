package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.KeyText;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.theme.Palette;

/**
 * Variables view: the variables of a program: live while it runs, those of any call while it is
 * paused.
 */
public final class VariablesView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "variables";

  private final Workbench workbench;
  private final DebugPresenter debug;
  private final VariablesPresenter presenter;
  private final Consumer<List<String>> plot;
  private final HiddenNames hidden;
  private final ValueTable table;
  private final DebugPanel panel;
  private final JTextField filter = new JTextField();
  private final JLabel omission = new JLabel();
  private final JPanel content = new JPanel(new BorderLayout());
  private Supplier<Optional<ControllerState>> past = Optional::empty;
  private boolean wasPast;

  /**
   * Without values yet.
   *
   * @param plot draws expressions over time
   */
  public VariablesView(
      Workbench workbench,
      DebugPresenter debug,
      Favourites favourites,
      HiddenNames hidden,
      Consumer<List<String>> plot) {
    assert EventQueue.isDispatchThread();
    this.workbench = workbench;
    this.debug = debug;
    this.plot = plot;
    this.hidden = hidden;
    presenter =
        new VariablesPresenter(
            debug.variables(), favourites, hidden, () -> System.nanoTime() / 1_000_000);
    table =
        new ValueTable(
            "variables-table",
            debug.variables(),
            false,
            (row, text) -> {},
            Optional.of(presenter::toggleFavourite));
    table.getAccessibleContext().setAccessibleName(text("variablesNameValueKindAndFavourite"));
    table.setComponentPopupMenu(menu());
    table.registerKeyboardAction(
        event -> plot(), KeyStroke.getKeyStroke("P"), JComponent.WHEN_FOCUSED);
    panel = new DebugPanel("variables", new JScrollPane(table));
    content.add(head(), BorderLayout.NORTH);
    content.add(panel, BorderLayout.CENTER);
    content.add(omission, BorderLayout.SOUTH);
    content.setName("variables-view");
    omission.setName("variables-omission");
    omission.setBorder(BorderFactory.createEmptyBorder(2, 8, 2, 8));
    omission.setVisible(false);
    debug.addListener(this::show);
    debug.variables().addListener(this::show);
    declareActions();
    show();
  }

  /** Has {@code listener} hear the expression of each variable that is selected. */
  public void whenSelected(Consumer<String> listener) {
    table.whenSelected(listener);
  }

  /** Has the values of a moment of the past shown, while there is one. */
  public void setPast(Supplier<Optional<ControllerState>> moment) {
    past = moment;
  }

  private JPanel head() {
    filter.setName("variables-filter");
    filter.putClientProperty("JTextField.placeholderText", text("filterVariables"));
    filter.putClientProperty("JTextField.showClearButton", true);
    filter.setToolTipText(text("showsOnlyVariablesWithThisIn"));
    filter.getAccessibleContext().setAccessibleName(text("filterVariables"));
    filter.getDocument().addDocumentListener(new Typed(() -> filtered(filter.getText())));
    filter.registerKeyboardAction(
        event -> filter.setText(""), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_FOCUSED);
    filter.registerKeyboardAction(
        event -> goToTable(), KeyStroke.getKeyStroke("DOWN"), JComponent.WHEN_FOCUSED);
    JPanel head = new JPanel(new MigLayout("insets 8", "[grow,fill,0::]"));
    head.add(filter);
    return head;
  }

  private void filtered(String text) {
    presenter.filter(text);
    show();
  }

  private void goToTable() {
    if (table.getRowCount() > 0) {
      if (table.selectedValue().isEmpty()) {
        table.selectFirstValue();
      }
      table.requestFocusInWindow();
    }
  }

  private JPopupMenu menu() {
    JPopupMenu menu = new JPopupMenu();
    menu.add(item(text("changeValue"), text("f2OrADoubleClick"), table::editValue));
    menu.add(item(text("copyValue"), text("putsTheValueOnTheClipboard"), table::copyValue));
    menu.add(item(text("copyExpression"), text("whatYieldsTheValue"), table::copyExpression));
    menu.addSeparator();
    menu.add(item(text("favouriteOnOrOff"), text("sFavouritesComeFirst"), table::toggleStar));
    menu.add(item(text("addToPlot"), text("pDrawsItOverTimeOn"), this::plot));
    menu.add(item(text("addToWatches"), text("showsItAtEveryStop"), this::watch));
    menu.addSeparator();
    menu.add(changeBefore(workbench));
    menu.addSeparator();
    menu.add(generated());
    return menu;
  }

  private JMenuItem generated() {
    JMenuItem item =
        new JCheckBoxMenuItem(text("thoseThatNodesMake")) {
          @Override
          public boolean isSelected() {
            return hidden.shown();
          }
        };
    item.setToolTipText(text("posesAndJointPositionsOfWaypoints"));
    item.addActionListener(event -> toggleGenerated());
    return item;
  }

  private void toggleGenerated() {
    hidden.toggle();
    show();
  }

  /** Leads to where the selected variable got its value. */
  static JMenuItem changeBefore(Workbench workbench) {
    String keys = KeyText.shown(workbench.actions().keysOf("past.change-before"));
    return item(
        text("goToItsLastChange"),
        keys.isEmpty() ? text("showsItsChange") : text("showsItsChangeByKeys", keys),
        () -> workbench.actions().run("past.change-before"));
  }

  static JMenuItem item(String title, String tip, Runnable run) {
    JMenuItem item = new JMenuItem(title);
    item.setToolTipText(tip);
    item.addActionListener(event -> run.run());
    return item;
  }

  private void declareActions() {
    var actions = workbench.actions();
    actions.add(Action.of(ID + ".filter", text("variablesFilter"), "", this::goToFilter));
    actions.add(
        new Action(
            ID + ".favourite",
            text("variablesFavouriteOnOrOff"),
            "",
            this::chosen,
            table::toggleStar));
    actions.add(
        Action.of(ID + ".generated", text("variablesThoseThatNodesMake"), "", this::toggleGenerated)
            .checked(hidden::shown));
    actions.add(new Action(ID + ".plot", text("variablesAddToPlot"), "", this::chosen, this::plot));
  }

  private boolean chosen() {
    return content.isShowing() && table.selectedValue().isPresent();
  }

  private void goToFilter() {
    workbench.show(ID);
    filter.requestFocusInWindow();
    filter.selectAll();
  }

  private void plot() {
    table.selectedValue().ifPresent(value -> plot.accept(List.of(ValueTable.expression(value))));
  }

  private void watch() {
    table
        .selectedValue()
        .ifPresent(
            value -> {
              debug.addWatch(ValueTable.expression(value));
              workbench.show(WatchesView.ID);
            });
  }

  private void show() {
    String note = presenter.note();
    if (note.isEmpty()) {
      panel.showContent(wasPast ? "" : debug.stopText());
    } else {
      panel.showNote(note);
    }
    String omitted = presenter.omission();
    if (!omitted.equals(omission.getText())) {
      omission.setText(omitted);
      omission.setToolTipText(text("theMenuOfARightClick", omitted));
      omission.setForeground(Palette.quiet());
      omission.setVisible(!omitted.isEmpty());
    }
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("variables");
  }

  @Override
  public JComponent component() {
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    Optional<ControllerState> then = past.get();
    if (then.isPresent()) {
      presenter.refresh(then.get(), false);
    } else {
      debug.refresh(state);
      if (wasPast) {
        // What a debugger found at a stop was replaced by the past.
        debug.selected().ifPresent(scope -> debug.select(scope.thread(), scope.depth()));
      }
      presenter.refresh(state, debug.showsValues());
    }
    wasPast = then.isPresent();
    show();
  }
}
