package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.table.AbstractTableModel;
import org.pendant.controller.installation.InstallationParts;
import org.pendant.controller.installation.SignalId;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.installation.Wiring;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.AnalogSignal;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.RegisterLevels;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.state.ControllerState;

/**
 * Signal table: the rows of the table of signals: what each is called, does, is made of, and is at.
 */
@SuppressWarnings("serial") // never written to a stream
final class SignalTable extends AbstractTableModel {
  static final int NAME = 1;
  private static final int USE = 2;
  private static final int DOMAIN = 3;
  private static final int LEVEL = 4;
  private static final List<String> COLUMNS =
      List.of(text("signal"), text("name"), text("useColumn"), text("madeOf"), text("level"));
  private static final String NOTHING = text("noUse");

  private final transient Editing editing;
  private final transient Consumer<String> refused;
  private transient List<Row> rows = List.of();
  private transient List<String> levels = List.of();
  private Group group = Group.DIGITAL;
  private String filter = "";

  /** Which signals are listed. */
  enum Group {
    DIGITAL(text("digital")),
    ANALOG(text("analog")),
    FLAGS(text("flags")),
    INPUT_REGISTERS(text("inputRegisters")),
    OUTPUT_REGISTERS(text("outputRegisters")),
    ALL(text("all"));

    private final String title;

    Group(String title) {
      this.title = title;
    }

    @Override
    public String toString() {
      return title;
    }
  }

  private record Row(String name, SignalId id) {}

  /**
   * The digital signals, at first.
   *
   * @param refused takes why a change cannot be made; empty when one was made
   */
  SignalTable(Editing editing, Consumer<String> refused) {
    this.editing = editing;
    this.refused = refused;
    show(Group.DIGITAL, "");
  }

  /** Lists the signals of a group whose own name or given name has a part. */
  void show(Group wanted, String part) {
    group = wanted;
    filter = part.strip().toLowerCase(Locale.ROOT);
    rows = all().stream().filter(this::wanted).toList();
    levels = List.of();
    fireTableDataChanged();
  }

  private boolean wanted(Row row) {
    boolean fits =
        switch (group) {
          case ALL -> true;
          case ANALOG -> row.id() instanceof SignalId.Analog;
          case DIGITAL ->
              row.id() instanceof SignalId.Digital d && d.signal().bank() != SignalBank.FLAG;
          case FLAGS ->
              row.id() instanceof SignalId.Digital d && d.signal().bank() == SignalBank.FLAG;
          case INPUT_REGISTERS ->
              row.id() instanceof SignalId.Register r && r.direction() == RegisterDirection.INPUT;
          case OUTPUT_REGISTERS ->
              row.id() instanceof SignalId.Register r && r.direction() == RegisterDirection.OUTPUT;
        };
    return fits
        && (row.name().contains(filter)
            || use(row).name().toLowerCase(Locale.ROOT).contains(filter));
  }

  private static List<Row> all() {
    List<Row> all = new ArrayList<>();
    for (SignalBank bank : SignalBank.values()) {
      for (int i = 0; i < bank.size(); i++) {
        Signal signal = new Signal(bank, i);
        all.add(new Row(signal.toString(), new SignalId.Digital(signal)));
      }
    }
    for (AnalogBank bank : AnalogBank.values()) {
      for (int i = 0; i < AnalogBank.SIZE; i++) {
        all.add(new Row(bank.name(i), new SignalId.Analog(bank, i)));
      }
    }
    for (RegisterDirection direction : RegisterDirection.values()) {
      for (RegisterKind kind : RegisterKind.values()) {
        for (int i = 0; i < kind.size(); i++) {
          all.add(new Row(direction.name(kind, i), new SignalId.Register(direction, kind, i)));
        }
      }
    }
    return all;
  }

  private SignalUse use(Row row) {
    return SignalNames.use(editing.now(), row.name());
  }

  /** The installation has changed. */
  void follow() {
    if (!rows.isEmpty()) {
      fireTableRowsUpdated(0, rows.size() - 1);
    }
  }

  /** Takes the levels of a snapshot. */
  void take(ControllerState state) {
    List<String> now = new ArrayList<>(rows.size());
    rows.forEach(each -> now.add(level(each.id(), state)));
    if (now.size() != levels.size()) {
      levels = now;
      follow();
      return;
    }
    List<String> before = levels;
    levels = now;
    for (int i = 0; i < now.size(); i++) {
      if (!now.get(i).equals(before.get(i))) {
        fireTableCellUpdated(i, LEVEL);
      }
    }
  }

  private static String level(SignalId id, ControllerState state) {
    return switch (id) {
      case SignalId.Digital digital ->
          state.io().level(digital.signal()) ? text("high") : text("low");
      case SignalId.Analog(AnalogBank bank, int index) -> {
        AnalogSignal signal = state.signals().analog().signal(bank, index);
        yield signal.domain() == AnalogDomain.CURRENT
            ? String.format(Locale.ROOT, "%.2f mA", signal.value() * 1000)
            : String.format(Locale.ROOT, "%.3f V", signal.value());
      }
      case SignalId.Register(RegisterDirection direction, RegisterKind kind, int address) -> {
        RegisterLevels registers = state.signals().registers(direction);
        yield switch (kind) {
          case BOOLEAN -> registers.bool(address) ? text("high") : text("low");
          case INTEGER -> Integer.toString(registers.integer(address));
          case FLOAT -> String.format(Locale.ROOT, "%.4g", registers.floating(address));
        };
      }
    };
  }

  @Override
  public int getRowCount() {
    return rows.size();
  }

  @Override
  public int getColumnCount() {
    return COLUMNS.size();
  }

  @Override
  public String getColumnName(int column) {
    return COLUMNS.get(column);
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return column == NAME || (column != LEVEL && !choices(row, column).isEmpty());
  }

  /** What a cell can be; empty if it cannot be changed. */
  List<String> choices(int row, int column) {
    SignalId id = rows.get(row).id();
    if (column == USE && id.takesInputAction()) {
      return List.of(inputWords(InputAction.DEFAULT), inputWords(InputAction.FREEDRIVE));
    }
    if (column == USE && id.takesOutputAction()) {
      return java.util.Arrays.stream(RunStateAction.values()).map(SignalTable::words).toList();
    }
    if (column == DOMAIN && id instanceof SignalId.Analog) {
      return List.of(words(AnalogDomain.CURRENT), words(AnalogDomain.VOLTAGE));
    }
    return List.of();
  }

  private static String inputWords(InputAction action) {
    return switch (action) {
      case DEFAULT -> NOTHING;
      case FREEDRIVE -> text("highFreedrive");
    };
  }

  private static String words(RunStateAction action) {
    return switch (action) {
      case PRESERVE -> NOTHING;
      case LOW_WHEN_NOT_RUNNING -> text("lowWhenNotRunning");
      case HIGH_WHEN_NOT_RUNNING -> text("highWhenNotRunning");
      case HIGH_WHEN_RUNNING -> text("highWhenRunningLowWhenStopped");
      case LOW_ON_UNSCHEDULED_STOP -> text("lowOnUnscheduledStop");
      case HIGH_FROM_START_LOW_ON_UNSCHEDULED_STOP -> text("highFromStartLowOnUnscheduled");
      case HIGH_WITH_POWER -> text("highWithPower");
      case LOW_WITH_POWER -> text("lowWithPower");
    };
  }

  private static String words(AnalogDomain domain) {
    return switch (domain) {
      case CURRENT -> text("current");
      case VOLTAGE -> text("voltage");
    };
  }

  private AnalogDomain domain(SignalId.Analog analog) {
    Wiring wiring = editing.now().wiring();
    return domains(wiring, analog.bank()).get(analog.index());
  }

  private static List<AnalogDomain> domains(Wiring wiring, AnalogBank bank) {
    return switch (bank) {
      case STANDARD_IN -> wiring.analogIn();
      case STANDARD_OUT -> wiring.analogOut();
      case TOOL_IN -> wiring.toolAnalogIn();
    };
  }

  @Override
  public Object getValueAt(int index, int column) {
    Row row = rows.get(index);
    SignalUse use = use(row);
    return switch (column) {
      case NAME -> use.name();
      case USE ->
          row.id().takesInputAction()
              ? inputWords(use.input())
              : row.id().takesOutputAction() ? words(use.output()) : "";
      case DOMAIN -> row.id() instanceof SignalId.Analog analog ? words(domain(analog)) : "";
      case LEVEL -> index < levels.size() ? levels.get(index) : "";
      default -> row.name();
    };
  }

  @Override
  public void setValueAt(Object value, int index, int column) {
    if (index >= rows.size() || value == null || value.equals(getValueAt(index, column))) {
      return;
    }
    Row row = rows.get(index);
    String text = value.toString();
    Consumer<InstallationParts> change =
        column == DOMAIN ? domainChange(row, text) : useChange(row, column, text);
    String why = editing.refusal(change);
    refused.accept(why);
    if (why.isEmpty()) {
      editing.take(change);
    }
    fireTableRowsUpdated(index, index);
  }

  private Consumer<InstallationParts> useChange(Row row, int column, String text) {
    SignalUse before = use(row);
    SignalUse after =
        column == NAME
            ? new SignalUse(row.name(), text.strip(), before.input(), before.output())
            : row.id().takesInputAction()
                ? new SignalUse(row.name(), before.name(), inputOf(text), before.output())
                : new SignalUse(row.name(), before.name(), before.input(), outputOf(text));
    return parts -> parts.signals = SignalNames.with(parts.signals, after);
  }

  private static InputAction inputOf(String words) {
    return words.equals(NOTHING) ? InputAction.DEFAULT : InputAction.FREEDRIVE;
  }

  private static RunStateAction outputOf(String words) {
    return java.util.Arrays.stream(RunStateAction.values())
        .filter(each -> words(each).equals(words))
        .findFirst()
        .orElse(RunStateAction.PRESERVE);
  }

  private Consumer<InstallationParts> domainChange(Row row, String text) {
    Optional<SignalId.Analog> analog =
        row.id() instanceof SignalId.Analog found ? Optional.of(found) : Optional.empty();
    AnalogDomain domain =
        text.equals(words(AnalogDomain.CURRENT)) ? AnalogDomain.CURRENT : AnalogDomain.VOLTAGE;
    return parts ->
        analog.ifPresent(
            found -> {
              List<AnalogDomain> next = new ArrayList<>(domains(parts.wiring, found.bank()));
              next.set(found.index(), domain);
              Wiring w = parts.wiring;
              parts.wiring =
                  new Wiring(
                      found.bank() == AnalogBank.STANDARD_IN ? next : w.analogIn(),
                      found.bank() == AnalogBank.STANDARD_OUT ? next : w.analogOut(),
                      found.bank() == AnalogBank.TOOL_IN ? next : w.toolAnalogIn(),
                      w.toolVoltage(),
                      w.toolOutputMode(),
                      w.toolPins(),
                      w.toolCommunication());
            });
  }
}
