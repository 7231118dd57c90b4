package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import javax.swing.AbstractAction;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.theme.Palette;

/**
 * Wiring page: which signals of the controller the devices of the cell are wired to, changed by
 * mouse or keys, and which of them are high.
 */
final class WiringPage {
  private static final String HELP = text("dragFromAPortToA");

  private final SceneDraft draft;
  private final UnaryOperator<String> signalName;
  private final WiringBoard board = new WiringBoard();
  private final JButton remove = new JButton(text("removeWire"));
  private final Remark said = new Remark("cell-wiring-said", this::color);
  private final JPanel panel =
      new JPanel(new MigLayout("insets 8 12 12 12, gap 8 6", "[grow, fill]", "[][grow, fill]"));
  private CellWiring wiring = new CellWiring(List.of());
  private Set<String> lit = Set.of();
  private List<WireRow> named = List.of();

  /** The row that keys draw a wire from; empty for none. */
  private Optional<WireRow> pending = Optional.empty();

  private boolean wrong;

  /**
   * @param signalName the name of a signal such as {@code digital_in[0]}; empty while it has none
   */
  WiringPage(SceneDraft draft, UnaryOperator<String> signalName) {
    this.draft = draft;
    this.signalName = signalName;
    panel.setName("cell-wiring");
    TitledCard.named(remove, "cell-wiring-remove", text("removeTheChosenWireDelete"));
    TitledCard.compact(remove);
    remove.addActionListener(event -> remove());
    JPanel head = new JPanel(new BorderLayout(12, 0));
    head.setOpaque(false);
    head.add(said, BorderLayout.CENTER);
    head.add(remove, BorderLayout.EAST);
    panel.add(head, "wmin 0, wrap");
    panel.add(board, "grow, wmin 0");
    board.onDrawn(this::wire);
    for (WireList list : List.of(board.signals(), board.ports())) {
      key(list, "ENTER", () -> enter(list));
      key(list, "ESCAPE", this::leave);
      key(list, "DELETE", this::remove);
      list.addListSelectionListener(event -> showRemove());
    }
    say("");
  }

  private Color color() {
    return wrong ? Palette.error() : Palette.quiet();
  }

  private static void key(JComponent at, String keys, Runnable run) {
    at.getInputMap().put(KeyStroke.getKeyStroke(keys), keys);
    at.getActionMap()
        .put(
            keys,
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                run.run();
              }
            });
  }

  JComponent component() {
    return panel;
  }

  /** What keys go to first. */
  JComponent first() {
    return board.ports();
  }

  private void say(String refusal) {
    wrong = !refusal.isEmpty();
    String hint =
        pending
            .map(
                row ->
                    row instanceof WireRow.OfPort(WirePort port)
                        ? text("chooseASignalForOfEnter", port.title(), port.device())
                        : text("chooseAPortForEnterWires", row.text()))
            .orElse(HELP);
    said.say(wrong ? text("notPossible", refusal) : hint);
    said.repaint();
  }

  private void enter(WireList list) {
    Optional<WireRow> row = list.selected();
    if (row.isEmpty()) {
      return;
    }
    WireList other = list == board.ports() ? board.signals() : board.ports();
    if (pending.isEmpty()
        || pending.get() instanceof WireRow.OfPort == row.get() instanceof WireRow.OfPort) {
      begin(row.get(), other);
      return;
    }
    String why = WireRow.refusal(pending.get(), row.get());
    if (!why.isEmpty()) {
      say(why);
      return;
    }
    WireRow from = pending.get();
    leave();
    if (from instanceof WireRow.OfPort(WirePort port)
        && row.get() instanceof WireRow.OfSignal signal) {
      wire(port, signal.signal());
    } else if (row.get() instanceof WireRow.OfPort(WirePort port)
        && from instanceof WireRow.OfSignal signal) {
      wire(port, signal.signal());
    }
  }

  private void begin(WireRow from, WireList other) {
    if (from instanceof WireRow.OfPort(WirePort port) && port.fixed()) {
      say(port.removalRefusal());
      return;
    }
    pending = Optional.of(from);
    board.offerFrom(pending);
    if (other.selected().filter(row -> WireRow.refusal(from, row).isEmpty()).isEmpty()) {
      other.select(
          row -> !(row instanceof WireRow.Heading) && WireRow.refusal(from, row).isEmpty());
    }
    other.requestFocusInWindow();
    say("");
  }

  /** Draws no wire by keys any more. */
  private void leave() {
    if (board.letGo()) {
      return;
    }
    boolean fromPort = pending.filter(row -> row instanceof WireRow.OfPort).isPresent();
    boolean was = pending.isPresent();
    pending = Optional.empty();
    board.offerFrom(pending);
    if (was) {
      (fromPort ? board.ports() : board.signals()).requestFocusInWindow();
    }
    say("");
  }

  private void wire(WirePort port, WireSignal signal) {
    attempt(port, signal.name());
  }

  private void remove() {
    Optional<WirePort> port = board.chosen().filter(WirePort::wired);
    port.ifPresent(
        each -> {
          if (each.removalRefusal().isEmpty()) {
            attempt(each, "");
          } else {
            say(each.removalRefusal());
          }
        });
  }

  private void attempt(WirePort port, String signal) {
    List<DeviceText> next = CellWiring.wired(devices(), port, signal);
    String why = Equipment.refusal(draft.scene(), Equipment.with(draft.equipment(), next));
    if (why.isEmpty()) {
      draft.setEquipment(Equipment.with(draft.equipment(), next));
    }
    say(why);
  }

  private List<DeviceText> devices() {
    return Equipment.devices(draft.equipment());
  }

  /** Shows the draft. */
  void show() {
    wiring = CellWiring.of(devices(), Equipment.rules(draft.equipment()));
    showRows();
    showRemove();
  }

  private void showRows() {
    named = signalRows();
    board.show(wiring, named, portRows());
  }

  private void showRemove() {
    remove.setEnabled(
        board.chosen().filter(each -> each.wired() && each.removalRefusal().isEmpty()).isPresent());
  }

  private List<WireRow> signalRows() {
    List<WireRow> rows = new ArrayList<>();
    List<CellWiring.Group> groups = new ArrayList<>(CellWiring.signals());
    groups.addAll(CellWiring.ofControllers(draft.controllers()));
    groups.addAll(CellWiring.signals(draft.devices().stream().flatMap(List::stream).toList()));
    for (CellWiring.Group group : groups) {
      rows.add(new WireRow.Heading(group.title(), "", false));
      for (WireSignal signal : group.signals()) {
        rows.add(new WireRow.OfSignal(signal, signalName.apply(signal.name())));
      }
    }
    return rows;
  }

  private List<WireRow> portRows() {
    List<WireRow> rows = new ArrayList<>();
    for (CellWiring.Box box : wiring.boxes()) {
      String note =
          box.reached().isEmpty() ? box.title() : text("reachedBy", box.title(), box.reached());
      rows.add(new WireRow.Heading(box.name(), note, lit.contains(box.name())));
      box.ports().forEach(port -> rows.add(new WireRow.OfPort(port)));
    }
    return rows;
  }

  /** Shows what is high, and which devices see or hold something. */
  void refresh(ControllerState state) {
    board.showLevels(high(state.io()));
    Set<String> litNow =
        state.devices().stream()
            .filter(DeviceState::on)
            .map(DeviceState::name)
            .collect(Collectors.toUnmodifiableSet());
    // people may have named a signal meanwhile
    if (!litNow.equals(lit) || !signalRows().equals(named)) {
      lit = litNow;
      showRows();
    }
  }

  private static Set<String> high(DigitalLevels levels) {
    Set<String> high = new HashSet<>();
    for (SignalBank bank : SignalBank.values()) {
      int bits = levels.bits(bank);
      for (int i = 0; bits != 0 && i < bank.size(); i++) {
        if ((bits >> i & 1) != 0) {
          high.add(bank.text() + "[" + i + "]");
        }
      }
    }
    return high;
  }
}
