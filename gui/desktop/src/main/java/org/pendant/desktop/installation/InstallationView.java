package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.Component;
import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.unit.RotationChoice;
import org.pendant.desktop.unit.ShownMeasure;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.layout.SettledScroll;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.WideContent;
import org.pendant.kit.theme.Palette;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;

/** Installation view: pages at the left, the chosen one at the right. */
public final class InstallationView implements View {
  static final String ID = "installation";

  private static final int GAP = 16;
  private static final int USUAL_CARD = 300;
  private static final int WIDEST_CARD = 640;
  private static final String PAGE = "installation.page";

  private final Workbench workbench;
  private final Editing editing;
  private final RotationChoice rotation;
  private final InstallationBar bar;
  private final SafetyDraft safety;

  /** Those that people have looked at: most are never made. */
  private final Map<PageName, Page> pages = new EnumMap<>(PageName.class);

  private final CardLayout cards = new CardLayout();
  private final JPanel shown = new JPanel(cards);
  private final JList<Object> list;
  private final JPanel content = new JPanel(new BorderLayout());
  private ArmDescription arm;
  private PageName page = PageName.TCP;

  /**
   * The screen for an installation.
   *
   * @param active what is shown and changed
   */
  public InstallationView(Workbench workbench, ActiveInstallation active) {
    this.workbench = workbench;
    arm = workbench.session().options().arm();
    editing = new Editing(active, this::arm, ShownMeasure.by(workbench.settings()));
    safety = new SafetyDraft(editing);
    rotation = new RotationChoice(workbench.settings());
    rotation.addListener(this::show);
    bar = new InstallationBar(workbench, active, editing);
    list = new JList<>(entries());
    build();
    addActions();
    active.addListener(this::show);
    active.addFileListener(bar::show);
    String last = workbench.settings().get(PAGE).orElse("");
    for (PageName each : PageName.values()) {
      page = each.id().equals(last) ? each : page;
    }
    bar.show();
  }

  private Page make(PageName name) {
    return switch (name) {
      case TCP -> new TcpPage(editing, rotation);
      case PAYLOAD -> new PayloadPage(editing);
      case MOUNTING -> new MountingPage(editing);
      case SIGNALS -> new SignalsPage(editing);
      case HOME -> new HomePage(editing, workbench.session()::state);
      case VARIABLES -> new VariablesPage(editing);
      case START_UP -> new StartUpPage(editing);
      case CONVEYORS -> new ConveyorPage(editing);
      case TOOL_CONNECTOR -> new ToolConnectorPage(editing);
      case LIMITS -> new LimitsPage(editing, safety);
      case JOINT_LIMITS -> new JointLimitsPage(safety);
      case PLANES -> new PlanesPage(editing, safety, workbench.session()::state);
      case TOOL_DIRECTION -> new ToolDirectionPage(safety);
      case FEATURES -> new FeaturesPage(editing, rotation, workbench.session()::state);
      case MODBUS -> new ModbusPage(editing);
      case ETHERNET_IP -> new EthernetIpPage(editing);
      case EXTERNAL_CONTROL -> new ExternalControlPage(editing);
    };
  }

  /** The safety settings that people type and have not applied yet. */
  public Optional<SafetyConfiguration> proposedSafety() {
    return safety.proposed();
  }

  private ArmDescription arm() {
    return arm;
  }

  /** Headings, which are texts, and the pages below them. */
  private static Object[] entries() {
    List<Object> entries = new ArrayList<>();
    String group = "";
    for (PageName each : PageName.values()) {
      if (!each.group().equals(group)) {
        group = each.group();
        entries.add(group);
      }
      entries.add(each);
    }
    return entries.toArray();
  }

  private void build() {
    TitledCard.named(list, "installation-pages", text("pagesOfTheInstallation"));
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setCellRenderer(new Entry());
    list.setSelectionModel(new Pages());
    list.addListSelectionListener(
        event -> {
          if (list.getSelectedValue() instanceof PageName chosen) {
            choose(chosen);
          }
        });
    JScrollPane left = new SettledScroll(list);
    left.setBorder(BorderFactory.createMatteBorder(0, 0, 0, 1, Palette.line()));
    JPanel middle =
        new JPanel(new MigLayout("insets 0, gap 0, fill", "[][grow, fill]", "[grow, fill]"));
    middle.add(left, "wmin pref");
    middle.add(shown, "wmin 0");
    content.setName("installation-view");
    content.getAccessibleContext().setAccessibleName(title());
    content.add(bar.component(), BorderLayout.NORTH);
    content.add(middle, BorderLayout.CENTER);
    key("control Z", bar::undo);
    key("control Y", bar::redo);
    key("control shift Z", bar::redo);
  }

  /** The page, made when people first look at it. */
  private Page page(PageName name) {
    Page known = pages.get(name);
    if (known != null) {
      return known;
    }
    Page made = make(name);
    pages.put(name, made);
    // one card a page: they all have one width
    JPanel sheet =
        new WideContent(
            new MigLayout(
                "insets " + GAP,
                "[grow, fill, :" + USUAL_CARD + ":" + WIDEST_CARD + "]",
                made.fillsHeight() ? "[grow, fill]" : ""));
    sheet.add(made.component());
    JScrollPane scroll = new SettledScroll(sheet);
    scroll.setName("installation-" + name.id());
    shown.add(scroll, name.id());
    return made;
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

  /** It may have to ask, so people have to see it. */
  private void turn(Runnable undoOrRedo) {
    workbench.show(id());
    undoOrRedo.run();
  }

  private void addActions() {
    workbench
        .actions()
        .add(
            new Action(
                "installation.undo",
                text("undoInTheInstallation"),
                "",
                editing::canUndo,
                () -> turn(bar::undo)));
    workbench
        .actions()
        .add(
            new Action(
                "installation.redo",
                text("redoInTheInstallation"),
                "",
                editing::canRedo,
                () -> turn(bar::redo)));
    for (PageName each : PageName.values()) {
      workbench
          .actions()
          .add(
              Action.of(
                  "installation.page-" + each.id(),
                  text("showInstallation", each.title()),
                  "",
                  () -> {
                    workbench.show(id());
                    choose(each);
                  }));
    }
  }

  private void choose(PageName next) {
    page = next;
    page(next).show();
    cards.show(shown, next.id());
    workbench.settings().put(PAGE, next.id());
    if (!next.equals(list.getSelectedValue())) {
      list.setSelectedValue(next, true);
    }
  }

  private void show() {
    bar.show();
    Page made = pages.get(page);
    if (made != null) {
      made.show();
    }
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("installation");
  }

  @Override
  public JComponent component() {
    if (pages.isEmpty()) {
      choose(page);
    }
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    String robot = workbench.session().options().robotId();
    if (!robot.equals(arm.id())) {
      arm = ArmLibrary.load(robot);
      show();
    }
    rotation.look();
    bar.refresh(state);
    page(page).refresh(state);
  }

  /** Headings cannot be chosen: the next page in the same direction is. */
  @SuppressWarnings("serial") // never written to a stream
  private final class Pages extends javax.swing.DefaultListSelectionModel {
    @Override
    public void setSelectionInterval(int from, int to) {
      int wanted = to;
      if (list.getModel().getElementAt(wanted) instanceof String) {
        boolean up = wanted < getLeadSelectionIndex();
        wanted = up && wanted > 0 ? wanted - 1 : wanted + 1;
      }
      super.setSelectionInterval(wanted, wanted);
    }
  }

  /** A heading or a page. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Entry extends DefaultListCellRenderer {
    @Override
    public Component getListCellRendererComponent(
        JList<?> of, Object item, int index, boolean selected, boolean focused) {
      boolean heading = item instanceof String;
      String text = item instanceof PageName page ? page.title() : String.valueOf(item);
      JLabel cell =
          (JLabel)
              super.getListCellRendererComponent(
                  of, text, index, selected && !heading, focused && !heading);
      int line = cell.getFontMetrics(cell.getFont()).getHeight();
      if (heading) {
        cell.setForeground(Palette.quiet());
        cell.setBorder(BorderFactory.createEmptyBorder(line * 2 / 3, line / 2, line / 5, line));
      } else {
        cell.setBorder(BorderFactory.createEmptyBorder(line / 5, line, line / 5, line));
      }
      return cell;
    }
  }
}
