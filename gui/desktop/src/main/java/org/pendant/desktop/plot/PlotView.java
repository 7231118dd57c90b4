package org.pendant.desktop.plot;

import static org.pendant.desktop.plot.PlotTexts.text;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.JComponent;
import javax.swing.JPanel;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.debug.HiddenNames;
import org.pendant.desktop.io.SignalLabels;
import org.pendant.desktop.session.SwitchListener;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;

/** Plot view: the screen of charts: what can be drawn on the left, the charts on the right. */
public final class PlotView implements View {
  private static final String ID = "plot";

  private final Workbench workbench;
  private final PlotPresenter presenter;

  /** Made when people first look at it. */
  private Optional<PlotPane> pane = Optional.empty();

  private final JPanel content = new JPanel(new BorderLayout());
  private boolean following;

  /**
   * Charts that were there the last time.
   *
   * @param labels names of signals
   * @param hidden variables that are left out
   */
  public PlotView(Workbench workbench, SignalLabels labels, HiddenNames hidden) {
    this.workbench = workbench;
    History history = new History(workbench.session()::recording);
    workbench.session().addSwitchListener(afresh(history));
    ChartQuantities quantities = ChartQuantities.standard(labels::of);
    presenter = new PlotPresenter(quantities, history, workbench.settings());
    quantities
        .variables()
        .hide(name -> hidden.hides(workbench.session().state().program().name(), name));
    hidden.addListener(() -> pane.ifPresent(each -> each.tree().refill()));
    presenter.onRefusal(workbench::notify);
    VariableTrace trace =
        new VariableTrace(workbench.session()::submit, EventQueue::invokeLater, workbench::notify);
    presenter.onTraced(trace::want);
    workbench.session().addFrameListener(trace);
    content.setName("plot-view");
    content.getAccessibleContext().setAccessibleName(title());
    declareActions();
  }

  private static SwitchListener afresh(History history) {
    return new SwitchListener() {
      @Override
      public void switchingOff() {}

      @Override
      public void switchedOn() {
        history.anotherController();
      }

      @Override
      public void shown() {
        history.anotherController();
      }
    };
  }

  private PlotPane pane() {
    if (pane.isEmpty()) {
      PlotPane made = new PlotPane(presenter, this::changed, this::add, this::export);
      content.add(made.component());
      pane = Optional.of(made);
    }
    return pane.get();
  }

  private void declareActions() {
    var actions = workbench.actions();
    actions.add(Action.of(ID + ".search", text("plotsAddAQuantity"), "", this::goToSearch));
    actions.add(
        Action.of(ID + ".pause", text("plotsPause"), "", this::togglePause)
            .checked(presenter::paused));
    actions.add(
        Action.of(ID + ".cursors", text("plotsCursors"), "", this::toggleCursors)
            .checked(() -> presenter.cursors().isPresent()));
    actions.add(Action.of(ID + ".export", text("plotsExport"), "", this::export));
  }

  private void goToSearch() {
    workbench.show(ID);
    pane().tree().focusSearch();
  }

  private void togglePause() {
    presenter.pause(!presenter.paused());
    changed();
  }

  private void toggleCursors() {
    presenter.showCursors(presenter.cursors().isEmpty());
    changed();
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("plots");
  }

  @Override
  public JComponent component() {
    var _ = pane();
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    showVariables(state);
    follow();
  }

  /** Much that is recorded and not shown yet follows piece by piece, other events between. */
  private void follow() {
    if (presenter.refresh()) {
      pane().stack().refresh();
    }
    if (presenter.history().behind() && !following) {
      following = true;
      EventQueue.invokeLater(
          () -> {
            following = false;
            follow();
          });
    }
  }

  private void showVariables(ControllerState state) {
    if (presenter.quantities().variables().show(state.variables())) {
      pane.ifPresent(each -> each.tree().refill());
    }
  }

  /**
   * Draws script variables, or the numbers in poses, lists and structs, and tells which.
   *
   * @param expressions such as {@code count} or {@code p[2]}
   */
  public void addVariables(List<String> expressions) {
    showVariables(workbench.session().state());
    List<ChartQuantity> found =
        expressions.stream()
            .flatMap(each -> presenter.quantities().variables().of(each).stream())
            .toList();
    if (found.isEmpty()) {
      workbench.notify(text("hasNoNumberThatCouldBe", String.join(", ", expressions)));
      return;
    }
    add(found);
    workbench.notify(
        text(
            found.size() == 1 ? "isDrawnOnThePlotsScreen" : "areDrawnOnThePlotsScreen",
            found.stream().map(ChartQuantity::label).collect(Collectors.joining(", "))));
  }

  private void add(List<ChartQuantity> chosen) {
    chosen.forEach(presenter::add);
    pane.ifPresent(each -> each.stack().rebuild());
  }

  private void changed() {
    presenter.refresh();
    pane.ifPresent(PlotPane::refresh);
  }

  private void export() {
    List<ChartQuantity> drawn =
        presenter.charts().stream()
            .flatMap(chart -> chart.traces().stream())
            .map(ChartTrace::quantity)
            .distinct()
            .toList();
    if (drawn.isEmpty()) {
      workbench.notify(text("nothingToExportNoQuantityIs"));
      return;
    }
    PlotCsv csv = PlotCsv.of(presenter.history(), drawn, presenter.window());
    SaveDialog.open(
        content,
        new SaveRequest(
            text("exportSamples", csv.rows()),
            workbench.exportFile("plot.csv"),
            List.of("csv"),
            workbench.openFiles()),
        csv::write,
        workbench::notify);
  }
}
