package org.pendant.desktop.ports;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import org.pendant.command.service.PortWishes;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.ports.PortsState.Trouble;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.layout.InnerScroll;
import org.pendant.kit.layout.SettledScroll;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.layout.WideContent;
import org.pendant.kit.table.RowKeys;
import org.pendant.kit.table.TableLook;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/** Ports view: the panel that opens the ports, and shows who is connected. */
public final class PortsView implements View {
  private static final String ID = "ports";
  private static final int GAP = 12;

  private final PortsPresenter presenter;
  private final JPanel content = new JPanel(new BorderLayout());
  private final JCheckBox on = new JCheckBox(PortsTexts.text("portsOpen"));
  private final JCheckBox remote = new JCheckBox(PortsTexts.text("remoteControl"));
  private final Map<PortField, JTextField> fields = new EnumMap<>(PortField.class);
  private final JTextArea summary = text("ports-summary", PortsTexts.text("stateOfThePorts"));
  private final JTextArea problem = text("ports-problem", PortsTexts.text("whatIsWrong"));
  private final JTextArea warning = text("ports-warning", PortsTexts.text("warning"));
  private final PortTable rows = new PortTable();
  private boolean showing;

  /** A panel for the ports of the workbench's session. */
  public PortsView(Workbench workbench, DesktopPorts ports) {
    presenter = new PortsPresenter(ports, workbench.settings(), Path.of("").toAbsolutePath());
    content.setName("ports-view");
    content.getAccessibleContext().setAccessibleName(title());
    JPanel sheet = new WideContent(new BorderLayout());
    sheet.add(top(workbench), BorderLayout.NORTH);
    sheet.add(table(), BorderLayout.CENTER);
    JScrollPane scroll = new SettledScroll(sheet);
    content.add(scroll);
    workbench
        .actions()
        .add(
            Action.of(
                "robot.ports",
                PortsTexts.text("ports"),
                "",
                () -> {
                  workbench.show(ID);
                  on.requestFocusInWindow();
                }));
    workbench
        .actions()
        .add(
            Action.of(
                    "robot.ports-switch",
                    PortsTexts.text("portsOpenForOtherPrograms"),
                    "",
                    () -> {
                      workbench.show(ID);
                      presenter.toggle();
                    })
                .checked(presenter::on));
    show();
  }

  private static JTextArea text(String name, String meaning) {
    JTextArea text =
        new JTextArea() {
          @Override
          public void updateUI() {
            super.updateUI();
            setFont(UIManager.getFont("Label.font"));
            setBorder(BorderFactory.createEmptyBorder());
            setOpaque(false);
          }

          /** New words are no reason to scroll. */
          @Override
          public void scrollRectToVisible(Rectangle wanted) {}
        };
    text.setName(name);
    text.getAccessibleContext().setAccessibleName(meaning);
    text.setEditable(false);
    text.setFocusable(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.setVisible(false);
    return text;
  }

  private JComponent top(Workbench workbench) {
    JPanel top =
        new JPanel(new MigLayout("insets 12, gap 8, wrap 2, hidemode 3", "[][grow,fill,0::]"));
    TitledCard.named(on, "ports-open", PortsTexts.text("letsOtherProgramsReachThisController"));
    on.addActionListener(event -> act(presenter::toggle));
    TitledCard.named(remote, "ports-remote", PortsTexts.text("remoteControlClientsMayControlThe"));
    remote.addActionListener(event -> act(() -> presenter.setRemote(remote.isSelected())));
    top.add(on);
    top.add(remote);
    for (PortField each : PortField.values()) {
      JTextField field = new JTextField(presenter.text(each));
      TitledCard.named(field, "ports-" + each.word(), each.meaning());
      field.getDocument().addDocumentListener(new Typed(() -> typed(each, field)));
      field.addActionListener(event -> act(presenter::toggle));
      JLabel label = new JLabel(Messages.shown(each.title()));
      label.setLabelFor(field);
      fields.put(each, field);
      top.add(label);
      top.add(field, "wmin 60");
    }
    for (JComponent each : new JComponent[] {problem, warning, summary}) {
      // Its lines break at the width that it gets, so that it must not ask for one.
      top.add(each, "span, growx, w 0:0");
    }
    top.add(clients(workbench), "span, alignx left");
    return top;
  }

  private static JButton clients(Workbench workbench) {
    JButton clients = new JButton(PortsTexts.text("clientsAndMessages"));
    TitledCard.named(clients, "ports-clients", PortsTexts.text("showWhoIsConnectedAndEvery"));
    clients.addActionListener(event -> workbench.show(ClientsView.ID));
    return clients;
  }

  private JComponent table() {
    JTable table =
        new JTable(rows) {
          @Override
          public String getToolTipText(MouseEvent event) {
            int row = rowAtPoint(event.getPoint());
            String who = row < 0 ? "" : rows.who(row);
            return who.isEmpty() ? null : who;
          }

          /** Room for all rows: a low panel scrolls as a whole, rather than half a row in it. */
          @Override
          public Dimension getPreferredScrollableViewportSize() {
            return new Dimension(getMinimumSize().width, getPreferredSize().height);
          }
        };
    table.setName("ports-table");
    table.getAccessibleContext().setAccessibleName(PortsTexts.text("openPorts"));
    table.setFillsViewportHeight(true);
    RowKeys.install(table);
    table.setShowGrid(false);
    table.getColumnModel().getColumn(0).setPreferredWidth(170);
    table.getColumnModel().getColumn(1).setPreferredWidth(150);
    table.getColumnModel().getColumn(2).setPreferredWidth(60);
    TableLook.fitTitles(table);
    JScrollPane scroll = InnerScroll.of(new JScrollPane(table));
    scroll.setBorder(BorderFactory.createEmptyBorder(0, GAP, GAP, GAP));
    return scroll;
  }

  private void act(Runnable change) {
    change.run();
    show();
  }

  private void typed(PortField field, JTextField source) {
    if (!showing) {
      presenter.type(field, source.getText());
      show();
    }
  }

  /** Opens the ports as the command line wants them. */
  public void open(PortWishes wishes) {
    presenter.openedWith(wishes);
    showing = true;
    fields.forEach((each, field) -> field.setText(presenter.text(each)));
    showing = false;
    show();
  }

  private void show() {
    on.setSelected(presenter.on());
    remote.setSelected(presenter.remote());
    Optional<Trouble> trouble = presenter.trouble();
    fields.forEach(
        (each, field) -> {
          boolean wrong = trouble.filter(it -> it.field() == each).isPresent();
          field.putClientProperty("JComponent.outline", wrong ? "error" : null);
          field.setEnabled(presenter.changeable());
        });
    show(problem, trouble.map(Trouble::text).orElse(""), Palette::error);
    show(warning, presenter.warning(), Palette::warning);
    show(summary, presenter.summary(), Palette::quiet);
    rows.show(presenter.rows());
  }

  private static void show(JTextArea area, String text, Supplier<Color> color) {
    if (!text.equals(area.getText())) {
      area.setText(text);
      area.setVisible(!text.isEmpty());
    }
    if (!color.get().equals(area.getForeground())) {
      area.setForeground(color.get());
    }
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return PortsTexts.text("portsTitle");
  }

  @Override
  public JComponent component() {
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    show();
  }
}
