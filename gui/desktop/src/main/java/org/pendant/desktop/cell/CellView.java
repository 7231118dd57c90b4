package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.awt.BorderLayout;
import java.awt.event.ActionEvent;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.view.ObjectHand;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.RotationChoice;
import org.pendant.desktop.unit.ShownMeasure;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.Measures;
import org.pendant.kit.layout.CardColumns;
import org.pendant.kit.layout.SettledScroll;
import org.pendant.kit.layout.WideContent;

/** Cell view: the screen on which people put things around the arm. */
public final class CellView implements View {
  /** Its id among the views. */
  public static final String ID = "cell";

  private static final int GAP = 16;
  private static final int WIDEST_CARD = 420;

  private final Workbench workbench;
  private final SceneDraft draft;
  private final UnaryOperator<String> signalName;
  private final RotationChoice rotation;
  private final JPanel content = new JPanel(new BorderLayout());

  /** Made when people first look at them. */
  private Optional<Cards> cards = Optional.empty();

  /** What the screen is made of. */
  private record Cards(
      CellBar bar,
      ObjectsCard objects,
      DevicesCard devices,
      RulesCard rules,
      LoadCard load,
      ToolPointsCard tool,
      LinksCard links,
      WiringPage wiring,
      JTabbedPane pages) {
    void show() {
      bar.show();
      wiring.show();
      devices.show();
      rules.show();
      objects.show();
      load.show();
      tool.show();
      links.show();
    }
  }

  /**
   * The screen for a scene.
   *
   * @param draft what is shown and changed
   * @param signalName the name of a signal such as {@code digital_in[0]}; empty while it has none
   */
  public CellView(Workbench workbench, SceneDraft draft, UnaryOperator<String> signalName) {
    this.workbench = workbench;
    this.draft = draft;
    this.signalName = signalName;
    rotation = new RotationChoice(workbench.settings());
    rotation.addListener(this::show);
    draft.addListener(this::show);
    content.setName("cell-view");
    content.getAccessibleContext().setAccessibleName(title());
    key("control Z", draft::undo);
    key("control Y", draft::redo);
    key("control shift Z", draft::redo);
    workbench
        .actions()
        .add(new Action("cell.undo", text("undoInTheScene"), "", draft::canUndo, draft::undo));
    workbench
        .actions()
        .add(new Action("cell.redo", text("redoInTheScene"), "", draft::canRedo, draft::redo));
    workbench
        .actions()
        .add(Action.of("cell.wiring", text("wireTheDevicesOfTheCell"), "", this::showWiring));
  }

  /**
   * A hand that moves objects and devices in 3D. Keys come here afterwards, not to 3D: Ctrl+Z takes
   * back what was moved.
   *
   * @param active whether it may now
   */
  public ObjectHand hand(BooleanSupplier active) {
    return new PlacingHand(
        draft,
        active,
        name -> cards().objects().choose(name),
        name -> cards().devices().choose(name),
        this::words,
        () -> workbench.show(ID));
  }

  /** A place in the base, such as {@code X 300 Y -250 Z 120 mm}. */
  private String words(Vector3 placeM) {
    Measure unit = ShownMeasure.by(workbench.settings()).of(Measure.MILLIMETRE);
    return "X "
        + unit.text(placeM.x())
        + "  Y "
        + unit.text(placeM.y())
        + "  Z "
        + unit.words(placeM.z());
  }

  /** The name of the device whose form is shown. */
  public Optional<String> chosenDevice() {
    return cards.flatMap(each -> each.devices().chosen());
  }

  private void showWiring() {
    workbench.show(ID);
    cards().pages().setSelectedComponent(cards().wiring().component());
    cards().wiring().first().requestFocusInWindow();
  }

  private void key(String keys, Runnable run) {
    content
        .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke(keys), keys);
    content
        .getActionMap()
        .put(
            keys,
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                run.run();
              }
            });
  }

  private Cards cards() {
    if (cards.isEmpty()) {
      Measures measures = ShownMeasure.by(workbench.settings());
      Cards made =
          new Cards(
              new CellBar(workbench, draft),
              new ObjectsCard(draft, rotation, measures, workbench.session()::state),
              new DevicesCard(
                  draft,
                  measures,
                  rotation,
                  signalName,
                  () -> SceneFrame.tcpM(workbench.session())),
              new RulesCard(draft),
              new LoadCard(draft, measures),
              new ToolPointsCard(draft, measures),
              new LinksCard(draft),
              new WiringPage(draft, signalName),
              new JTabbedPane());
      JPanel sheet = new WideContent(new CardColumns(GAP, WIDEST_CARD));
      sheet.add(made.objects.component());
      JPanel second =
          new JPanel(new MigLayout("insets 0, gap 0 " + GAP + ", wrap", "[grow, fill]"));
      second.setOpaque(false);
      second.add(made.devices.component());
      second.add(made.rules.component());
      second.add(made.load.component());
      second.add(made.tool.component());
      second.add(made.links.component());
      sheet.add(second);
      JScrollPane scroll = new SettledScroll(sheet);
      scroll.setName("cell-scroll");
      content.add(made.bar.component(), BorderLayout.NORTH);
      made.pages.setName("cell-pages");
      made.pages.addTab(text("forms"), scroll);
      made.pages.addTab(text("wiring"), made.wiring.component());
      content.add(made.pages, BorderLayout.CENTER);
      cards = Optional.of(made);
      made.show();
    }
    return cards.get();
  }

  private void show() {
    cards.ifPresent(Cards::show);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("cell");
  }

  @Override
  public JComponent component() {
    var _ = cards();
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    rotation.look();
    cards().bar().refresh();
    cards().wiring().refresh(state);
    cards().devices().refresh(state.devices(), FormMemory.read(workbench.settings()).length());
  }
}
