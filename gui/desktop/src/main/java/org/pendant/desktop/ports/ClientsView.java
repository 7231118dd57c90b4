package org.pendant.desktop.ports;

import static org.pendant.desktop.ports.PortsTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import javax.swing.AbstractAction;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableColumnModel;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.timeline.ClientMark;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.table.RowKeys;
import org.pendant.kit.table.TableLook;
import org.pendant.protocols.trace.LiveTrace;
import org.pendant.protocols.trace.WireMessage;
import org.pendant.protocols.wire.Direction;

/** Clients view: who is connected to the ports, and every message of theirs. */
public final class ClientsView implements View {
  /** Its name among the views. */
  public static final String ID = "clients";

  private static final int[] CLIENT_WIDTHS = {124, 84, 50, 84, 118, 120, 72, 128};
  private static final int[] MIN_CLIENT_WIDTHS = {116, 78, 40, 66, 66, 114, 60, 62};
  private static final int[] MESSAGE_WIDTHS = {94, 22, 116, 78, 132, 2000};
  private static final int[] MIN_MESSAGE_WIDTHS = {94, 22, 116, 78, 118, 100};

  private final Workbench workbench;
  private final ClientsPresenter presenter;
  private final JPanel content = new JPanel(new BorderLayout());
  private final ClientTable clients = new ClientTable();
  private final MessageTable messages = new MessageTable();
  private final JTable clientTable = clientTable();
  private final JTable messageTable = new JTable(messages);
  private final JScrollPane messageScroll = new JScrollPane(messageTable);
  private final JTextArea detail = new JTextArea();
  private final JTextField search = new JTextField(14);
  private final JComboBox<String> direction =
      new JComboBox<>(
          new String[] {text("bothDirections"), text("fromClients"), text("toClients")});
  private final JToggleButton effects = new JToggleButton(text("effects"));
  private final JToggleButton streamed = new JToggleButton(text("data"));
  private final JButton all = new JButton(text("allClients"));
  private final JToggleButton record = new JToggleButton(text("record"), true);
  private final JLabel summary = summary();
  private final JButton moment = new JButton(text("moment"));
  private final DoubleConsumer lookAt;
  private boolean showing;
  private long selected = -1;

  /**
   * A screen for the clients of {@code ports}.
   *
   * @param lookAt shows a moment, robot time in s, in the timeline and all views
   */
  public ClientsView(Workbench workbench, DesktopPorts ports, DoubleConsumer lookAt) {
    this.workbench = workbench;
    this.lookAt = lookAt;
    presenter = new ClientsPresenter(ports);
    content.setName("clients-view");
    content.getAccessibleContext().setAccessibleName(title());
    content.add(bar(), BorderLayout.NORTH);
    content.add(tables(), BorderLayout.CENTER);
    workbench
        .actions()
        .add(
            Action.of(
                "robot.clients",
                text("clientsOfThePorts"),
                "",
                () -> {
                  workbench.show(ID);
                  search.requestFocusInWindow();
                }));
    workbench
        .actions()
        .add(
            Action.of("clients.record", text("clientsRecordMessages"), "", this::toggleRecording)
                .checked(presenter::recording));
    workbench
        .actions()
        .add(Action.of("clients.clear", text("clientsClearMessages"), "", this::clear));
    workbench
        .actions()
        .add(Action.of("clients.export", text("clientsExportMessages"), "", this::export));
  }

  private JComponent bar() {
    JPanel bar = new JPanel(new WrappingRow(8));
    bar.setName("clients-bar");
    search.putClientProperty("JTextField.placeholderText", text("filterMessages"));
    search.putClientProperty("JTextField.showClearButton", true);
    TitledCard.named(search, "clients-filter", text("showMessagesWithThisText"));
    search
        .getDocument()
        .addDocumentListener(
            new Typed(() -> filter(presenter.filter().withText(search.getText()))));
    bar.add(search);
    TitledCard.named(direction, "clients-direction", text("whichWayMessagesWent"));
    direction.addActionListener(
        event ->
            filter(
                presenter
                    .filter()
                    .withDirection(
                        switch (direction.getSelectedIndex()) {
                          case 1 -> Optional.of(Direction.IN);
                          case 2 -> Optional.of(Direction.OUT);
                          default -> Optional.empty();
                        })));
    bar.add(direction);
    all.addActionListener(event -> clientTable.clearSelection());
    add(bar, all, "clients-all", text("showTheMessagesOfAllClients"));
    effects.addActionListener(
        event -> filter(presenter.filter().withEffects(effects.isSelected())));
    add(bar, effects, "clients-effects", text("showOnlyWhatDoesSomethingTo"));
    streamed.addActionListener(
        event -> filter(presenter.filter().withStreamed(streamed.isSelected())));
    add(bar, streamed, "clients-streamed", text("showAlsoWhatComesByItself"));
    record.addActionListener(event -> recordAs(record.isSelected()));
    add(bar, record, "clients-record", text("keepMessagesAsTheyComeOff"));
    moment.addActionListener(event -> showMoment());
    add(bar, moment, "clients-moment", text("showTheMomentOfTheMessage"));
    JButton clear = new JButton(text("clear"));
    clear.addActionListener(event -> clear());
    add(bar, clear, "clients-clear", text("forgetTheMessages"));
    JButton export = new JButton(text("export"));
    export.addActionListener(event -> export());
    add(bar, export, "clients-export", text("saveTheMessagesShownAsJson"));
    TitledCard.named(summary, "clients-summary", text("howManyMessagesAreShown"));
    bar.add(summary);
    return bar;
  }

  private static void add(JPanel bar, AbstractButton button, String name, String tip) {
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    TitledCard.named(button, name, tip);
    bar.add(button);
  }

  /** As wide as its longest words, or the bar would get another row and lose it again. */
  private static JLabel summary() {
    return new JLabel() {
      @Override
      public Dimension getPreferredSize() {
        int width = getFontMetrics(getFont()).stringWidth(text("widestSummary"));
        return new Dimension(width, super.getPreferredSize().height);
      }
    };
  }

  private JTable clientTable() {
    return new JTable(clients) {
      @Override
      public String getToolTipText(MouseEvent event) {
        int row = rowAtPoint(event.getPoint());
        int column = columnAtPoint(event.getPoint());
        String tip = row < 0 || column < 0 ? "" : clients.tip(row, column);
        return tip.isEmpty() ? null : tip;
      }
    };
  }

  private JComponent tables() {
    prepare(clientTable, "clients-table", text("clients"), CLIENT_WIDTHS);
    keepWidths(clientTable, MIN_CLIENT_WIDTHS);
    clientTable.getColumn(text("in")).setCellRenderer(new RateCellRenderer());
    clientTable.getColumn(text("out")).setCellRenderer(new RateCellRenderer());
    clientTable.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    clientTable.getSelectionModel().addListSelectionListener(event -> clientChosen());
    prepare(messageTable, "clients-messages", text("messages"), MESSAGE_WIDTHS);
    keepWidths(messageTable, MIN_MESSAGE_WIDTHS);
    key(clientTable, "ESCAPE", clientTable::clearSelection);
    messageScroll
        .getViewport()
        .addComponentListener(
            new ComponentAdapter() {
              @Override
              public void componentResized(ComponentEvent event) {
                keepInSight();
              }
            });
    key(messageTable, "ENTER", this::showMoment);
    messageTable.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            if (event.getClickCount() == 2) {
              showMoment();
            }
          }
        });
    key(content, "control F", search::requestFocusInWindow);
    messageTable.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    messageTable.setDefaultRenderer(Object.class, new MessageCellRenderer());
    messageTable.getSelectionModel().addListSelectionListener(event -> messageChosen());
    detail.setName("clients-detail");
    detail.getAccessibleContext().setAccessibleName(text("theWholeMessage"));
    detail.putClientProperty("FlatLaf.styleClass", "monospaced");
    detail.setEditable(false);
    detail.setLineWrap(true);
    detail.setWrapStyleWord(true);
    detail.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));
    detail.setText(text("chooseAClientToSeeIts"));
    JScrollPane whole = new JScrollPane(detail);
    whole.setBorder(BorderFactory.createEmptyBorder());
    whole.setPreferredSize(new Dimension(400, 170));
    messageScroll.setBorder(BorderFactory.createEmptyBorder());
    messageScroll.setPreferredSize(new Dimension(400, 250));
    JSplitPane lower = split("clients-split", messageScroll, whole, 0.65);
    JScrollPane upper = new JScrollPane(clientTable);
    upper.setBorder(BorderFactory.createEmptyBorder());
    upper.setPreferredSize(UIScale.scale(new Dimension(400, 120)));
    return split("clients-upper", upper, lower, 0.0);
  }

  private static JSplitPane split(String name, JComponent top, JComponent bottom, double weight) {
    JSplitPane split = new JSplitPane(JSplitPane.VERTICAL_SPLIT, top, bottom);
    split.setName(name);
    split.setResizeWeight(weight);
    split.setBorder(BorderFactory.createEmptyBorder());
    top.setMinimumSize(UIScale.scale(new Dimension(0, 106)));
    bottom.setMinimumSize(UIScale.scale(new Dimension(0, 60)));
    return split;
  }

  private static void key(JComponent on, String keys, Runnable run) {
    on.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke(keys), keys);
    on.getActionMap()
        .put(
            keys,
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                run.run();
              }
            });
  }

  private static void prepare(JTable table, String name, String meaning, int... widths) {
    table.setName(name);
    table.getAccessibleContext().setAccessibleName(meaning);
    table.setFillsViewportHeight(true);
    RowKeys.install(table);
    // Tab leaves the table: nothing in its cells can be changed.
    table.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
    table.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
    table.setShowGrid(false);
    TableColumnModel columns = table.getColumnModel();
    for (int i = 0; i < widths.length; i++) {
      columns.getColumn(i).setPreferredWidth(UIScale.scale(widths[i]));
    }
    TableLook.fitTitles(table);
  }

  /** Columns are at least so wide. */
  private static void keepWidths(JTable table, int... widths) {
    for (int i = 0; i < widths.length; i++) {
      table.getColumnModel().getColumn(i).setMinWidth(UIScale.scale(widths[i]));
    }
    TableLook.fitTitles(table);
  }

  /** What does something to the robot stands out. */
  @SuppressWarnings("serial") // never written to a stream
  private final class MessageCellRenderer extends DefaultTableCellRenderer {
    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean chosen, boolean focused, int row, int column) {
      super.getTableCellRendererComponent(table, value, chosen, focused, row, column);
      boolean acts =
          column == messages.getColumnCount() - 1
              && messages.row(row).reading().effect().isPresent();
      setToolTipText(value.toString());
      setFont(acts ? table.getFont().deriveFont(Font.BOLD) : table.getFont());
      return this;
    }
  }

  private void filter(MessageFilter wanted) {
    if (!showing) {
      presenter.setFilter(wanted);
      show();
    }
  }

  private void clientChosen() {
    int row = clientTable.getSelectedRow();
    if (showing) {
      return;
    }
    filter(
        presenter
            .filter()
            .withClient(row < 0 ? Optional.empty() : Optional.of(clients.row(row).peers())));
    if (row >= 0) {
      messageTable.clearSelection();
      tell(MessageDetail.of(clients.row(row)));
    }
  }

  private void messageChosen() {
    int row = messageTable.getSelectedRow();
    if (!showing && row >= 0 && messages.row(row).number() != selected) {
      selected = messages.row(row).number();
      tell(MessageDetail.of(messages.row(row)));
    } else if (!showing && row < 0) {
      selected = -1;
    }
  }

  private void tell(String text) {
    detail.setText(text);
    detail.setCaretPosition(0);
  }

  /** What clients did, for the timeline. */
  public List<ClientMark> marks() {
    return presenter.marks(System.nanoTime());
  }

  /** Brings a message in sight, also one that the filter hides. */
  public void showMessage(long number) {
    workbench.show(ID);
    presenter.look(System.nanoTime());
    if (presenter.messages().stream().noneMatch(each -> each.number() == number)) {
      clientTable.clearSelection();
      search.setText("");
      filter(MessageFilter.USUAL);
    }
    show();
    int row = messages.rowOf(number);
    if (row >= 0) {
      messageTable.setRowSelectionInterval(row, row);
      keepInSight();
    }
  }

  private void keepInSight() {
    int row = messageTable.getSelectedRow();
    if (row >= 0) {
      messageTable.scrollRectToVisible(messageTable.getCellRect(row, 0, true));
    }
  }

  private void showMoment() {
    int row = messageTable.getSelectedRow();
    if (row >= 0) {
      lookAt.accept(messages.row(row).robotTimeS());
    }
  }

  private void toggleRecording() {
    workbench.show(ID);
    recordAs(!presenter.recording());
  }

  private void recordAs(boolean wanted) {
    presenter.setRecording(wanted);
    show();
  }

  private void clear() {
    presenter.clear();
    show();
  }

  private void export() {
    List<WireMessage> shown = presenter.messages();
    SaveDialog.open(
        content,
        new SaveRequest(
            text("exportMessagesOfClients", shown.size()),
            workbench.exportFile("clients.jsonl"),
            List.of("jsonl", "pcap"),
            workbench.openFiles()),
        file -> AtomicFile.write(file, out -> LiveTrace.write(shown, file, out)),
        workbench::notify);
  }

  /** Shows what the presenter has; chosen rows stay chosen, and the newest in sight if it was. */
  private void show() {
    showing = true;
    record.setSelected(presenter.recording());
    MessageFilter filter = presenter.filter();
    effects.setSelected(filter.effects());
    streamed.setSelected(filter.streamed());
    int way = filter.direction().map(each -> each == Direction.IN ? 1 : 2).orElse(0);
    if (direction.getSelectedIndex() != way) {
      direction.setSelectedIndex(way);
    }
    moment.setEnabled(messageTable.getSelectedRow() >= 0);
    all.setEnabled(presenter.filter().client().isPresent());
    summary.setText(presenter.summary());
    int client = clientTable.getSelectedRow();
    Optional<ClientRow> chosen = client < 0 ? Optional.empty() : Optional.of(clients.row(client));
    if (clients.show(presenter.clients())) {
      chosen.ifPresent(this::chooseAgain);
    }
    JScrollBar bar = messageScroll.getVerticalScrollBar();
    boolean atEnd = bar.getValue() + bar.getVisibleAmount() >= bar.getMaximum() - 2;
    if (messages.replace(presenter.messages())) {
      int row = selected < 0 ? -1 : messages.rowOf(selected);
      if (row >= 0) {
        messageTable.setRowSelectionInterval(row, row);
      } else if (atEnd && messages.getRowCount() > 0) {
        messageTable.scrollRectToVisible(
            messageTable.getCellRect(messages.getRowCount() - 1, 0, true));
      }
    }
    showing = false;
  }

  /** A client that has left leaves its messages in sight. */
  private void chooseAgain(ClientRow before) {
    for (int row = 0; row < clients.getRowCount(); row++) {
      if (clients.row(row).peers().equals(before.peers())) {
        clientTable.setRowSelectionInterval(row, row);
        return;
      }
    }
    presenter.setFilter(presenter.filter().withClient(Optional.empty()));
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("clients");
  }

  @Override
  public JComponent component() {
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    if (presenter.look(System.nanoTime())) {
      show();
    }
  }
}
