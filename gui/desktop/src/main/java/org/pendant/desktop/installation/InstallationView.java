package org.pendant.desktop.installation;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.Component;
import java.awt.event.ActionEvent;
import java.util.LinkedHashMap;
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
import javax.swing.ScrollPaneConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.layout.CardSheet;
import org.pendant.kit.layout.SettledScroll;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.theme.Palette;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;

/** Installation view: pages at the left, the chosen one at the right. */
public final class InstallationView implements View {
  private static final int GAP = 16;
  private static final int USUAL_CARD = 300;
  private static final int WIDEST_CARD = 640;
  private static final String PAGE = "installation.page";

  private final Workbench workbench;
  private final Editing editing;
  private final RotationChoice rotation;
  private final InstallationBar bar;
  private final SafetyDraft safety;
  private final Map<String, List<Page>> groups = new LinkedHashMap<>();
  private final List<Page> pages;
  private final CardLayout cards = new CardLayout();
  private final JPanel shown = new JPanel(cards);
  private final JList<Object> list;
  private final JPanel content = new JPanel(new BorderLayout());
  private ArmDescription arm;
  private Page page;

  /**
   * The screen for an installation.
   *
   * @param active what is shown and changed
   */
  public InstallationView(Workbench workbench, ActiveInstallation active) {
    this.workbench = workbench;
    arm = workbench.session().options().arm();
    editing = new Editing(active, this::arm);
    safety = new SafetyDraft(editing);
    rotation = new RotationChoice(workbench.settings());
    rotation.addListener(this::show);
    makePages();
    pages = groups.values().stream().flatMap(List::stream).toList();
    bar = new InstallationBar(workbench, active, editing);
    list = new JList<>(entries());
    page = pages.getFirst();
    build();
    addActions();
    active.addListener(this::show);
    active.addFileListener(bar::show);
    String last = workbench.settings().get(PAGE).orElse("");
    choose(pages.stream().filter(each -> each.id().equals(last)).findFirst().orElse(page));
    show();
  }

  private void makePages() {
    groups.put(
        "General",
        List.of(
            new TcpPage(editing, rotation),
            new PayloadPage(editing),
            new MountingPage(editing),
            new SignalsPage(editing),
            new HomePage(editing, workbench.session()::state),
            new VariablesPage(editing),
            new StartUpPage(editing),
            new ConveyorPage(editing),
            new ToolConnectorPage(editing)));
    groups.put(
        "Safety",
        List.of(
            new LimitsPage(editing, safety),
            new JointLimitsPage(safety),
            new PlanesPage(editing, safety, workbench.session()::state),
            new ToolDirectionPage(safety)));
    groups.put(
        "Features", List.of(new FeaturesPage(editing, rotation, workbench.session()::state)));
    groups.put("Fieldbus", List.of(new ModbusPage(editing), new EthernetIpPage(editing)));
    groups.put("URCaps", List.of(new ExternalControlPage(editing)));
  }

  /** The safety settings that people type and have not applied yet. */
  public Optional<SafetyConfiguration> proposedSafety() {
    return safety.proposed();
  }

  private ArmDescription arm() {
    return arm;
  }

  /** Headings, which are texts, and the pages below them. */
  private Object[] entries() {
    List<Object> entries = new java.util.ArrayList<>();
    groups.forEach(
        (title, below) -> {
          entries.add(title);
          entries.addAll(below);
        });
    return entries.toArray();
  }

  private void build() {
    TitledCard.named(list, "installation-pages", "Pages of the installation");
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setCellRenderer(new Entry());
    list.setSelectionModel(new Pages());
    list.addListSelectionListener(
        event -> {
          if (list.getSelectedValue() instanceof Page chosen) {
            choose(chosen);
          }
        });
    for (Page each : pages) {
      JPanel sheet = new CardSheet(GAP, WIDEST_CARD);
      // one card a page: they all have one width
      sheet.setLayout(
          new MigLayout(
              "insets " + GAP,
              "[grow, fill, :" + USUAL_CARD + ":" + WIDEST_CARD + "]",
              each.fillsHeight() ? "[grow, fill]" : ""));
      sheet.add(each.component());
      JScrollPane scroll = scroll(sheet);
      scroll.setName("installation-" + each.id());
      shown.add(scroll, each.id());
    }
    JScrollPane left = scroll(list);
    left.setBorder(BorderFactory.createMatteBorder(0, 0, 0, 1, Palette.line()));
    JPanel middle =
        new JPanel(new MigLayout("insets 0, gap 0, fill", "[][grow, fill]", "[grow, fill]"));
    middle.add(left, "wmin pref");
    middle.add(shown, "wmin 0");
    content.setName("installation-view");
    content.getAccessibleContext().setAccessibleName(title());
    content.add(bar.component(), BorderLayout.NORTH);
    content.add(middle, BorderLayout.CENTER);
    key("control Z", editing::undo);
    key("control Y", editing::redo);
    key("control shift Z", editing::redo);
  }

  private static JScrollPane scroll(JComponent inside) {
    JScrollPane scroll =
        new SettledScroll(
            inside,
            ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
            ScrollPaneConstants.HORIZONTAL_SCROLLBAR_AS_NEEDED);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    return scroll;
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

  private void addActions() {
    workbench
        .actions()
        .add(
            new Action(
                "installation.undo",
                "Undo in the installation",
                "",
                editing::canUndo,
                editing::undo));
    workbench
        .actions()
        .add(
            new Action(
                "installation.redo",
                "Redo in the installation",
                "",
                editing::canRedo,
                editing::redo));
    for (Page each : pages) {
      workbench
          .actions()
          .add(
              Action.of(
                  "installation.page-" + each.id(),
                  "Show installation: " + each.title(),
                  "",
                  () -> {
                    workbench.show(id());
                    choose(each);
                  }));
    }
  }

  private void choose(Page next) {
    page = next;
    cards.show(shown, next.id());
    workbench.settings().put(PAGE, next.id());
    if (!next.equals(list.getSelectedValue())) {
      list.setSelectedValue(next, true);
    }
    next.show();
  }

  private void show() {
    bar.show();
    page.show();
  }

  @Override
  public String id() {
    return "installation";
  }

  @Override
  public String title() {
    return "Installation";
  }

  @Override
  public JComponent component() {
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
    page.refresh(state);
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
      String text = item instanceof Page page ? page.title() : String.valueOf(item);
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
