package org.pendant.desktop.ports;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.command.service.PortWishes;
import org.pendant.desktop.ports.PortsState.Trouble;
import org.pendant.kit.settings.Settings;
import org.pendant.kit.text.Messages;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.TcpPort;

/**
 * Ports presenter: what the panel of the ports shows and allows. It has no Swing; the dispatch
 * thread uses it.
 */
final class PortsPresenter {
  private static final String SETTING = "ports.";
  private static final String REMOTE = SETTING + "remote";

  /** As many ports that could not be had are named. */
  private static final int MAX_MISSING = 3;

  private final DesktopPorts ports;
  private final Settings settings;
  private final Map<PortField, String> texts = new EnumMap<>(PortField.class);
  private Optional<Trouble> typed = Optional.empty();

  /** What was the matter before the fields were changed. */
  private Optional<PortsState> outdated = Optional.empty();

  private boolean remote;

  /** A port that is open; clients by their addresses, with commas between. */
  record Row(String name, String address, int clients, String who) {}

  /** Shows {@code ports}, with what was typed last time. */
  PortsPresenter(DesktopPorts ports, Settings settings, Path standardFolder) {
    this.ports = ports;
    this.settings = settings;
    for (PortField each : PortField.values()) {
      texts.put(
          each,
          settings.get(SETTING + each.word()).orElseGet(() -> standard(each, standardFolder)));
    }
    remote = settings.get(REMOTE).map(Boolean::parseBoolean).orElse(true);
  }

  private static String standard(PortField field, Path folder) {
    return switch (field) {
      case HOST -> PortWishes.STANDARD_HOST;
      case OFFSET -> "0";
      case MODBUS -> "";
      case PROGRAMS -> folder.toString();
    };
  }

  /** What stands in a field. */
  String text(PortField field) {
    return texts.get(field);
  }

  /** A field has another text; it counts when the ports are opened next. */
  void type(PortField field, String text) {
    texts.put(field, text);
    settings.put(SETTING + field.word(), text);
    outdated = Optional.of(ports.state());
    var _ = wishes();
  }

  /** Shows what the ports were opened with from outside of the panel. */
  void openedWith(PortWishes wishes) {
    texts.put(PortField.HOST, wishes.host());
    texts.put(PortField.OFFSET, Integer.toString(wishes.offset()));
    texts.put(
        PortField.MODBUS,
        wishes.modbus().isPresent() ? Integer.toString(wishes.modbus().getAsInt()) : "");
    texts.put(PortField.PROGRAMS, wishes.programs().toString());
    remote = wishes.remote();
    ports.open(wishes);
  }

  /** Opens the ports, or closes them. */
  void toggle() {
    switch (ports.state()) {
      case PortsState.Open _, PortsState.Opening _ -> ports.close();
      case PortsState.Closed _ -> wishes().ifPresent(ports::open);
    }
  }

  /**
   * What the fields say; where they say nothing, the field with the mistake is known afterwards.
   */
  private Optional<PortWishes> wishes() {
    String host = text(PortField.HOST).strip();
    if (host.isEmpty()) {
      return mistake(PortField.HOST, PortsTexts.text("addressIsEmpty"));
    }
    OptionalInt offset = PortWishes.number(text(PortField.OFFSET), 0, PortWishes.MAX_OFFSET);
    if (offset.isEmpty()) {
      return mistake(PortField.OFFSET, notBetween(PortField.OFFSET, 0, PortWishes.MAX_OFFSET));
    }
    boolean chosen = !text(PortField.MODBUS).isBlank();
    OptionalInt modbus = PortWishes.number(text(PortField.MODBUS), 1, PortWishes.MAX_PORT);
    if (chosen && modbus.isEmpty()) {
      return mistake(
          PortField.MODBUS,
          PortsTexts.text("orEmpty", notBetween(PortField.MODBUS, 1, PortWishes.MAX_PORT)));
    }
    try {
      Path programs = Path.of(text(PortField.PROGRAMS).strip()).toAbsolutePath().normalize();
      typed = Optional.empty();
      return Optional.of(new PortWishes(host, offset.getAsInt(), modbus, programs, remote));
    } catch (InvalidPathException e) {
      return mistake(
          PortField.PROGRAMS, PortsTexts.text("isNoNameOfAFolder", text(PortField.PROGRAMS)));
    }
  }

  private String notBetween(PortField field, int least, int most) {
    return PortsTexts.text("mustBeBetween", field.title(), text(field), least, most);
  }

  private Optional<PortWishes> mistake(PortField field, String text) {
    typed = Optional.of(new Trouble(field, text));
    return Optional.empty();
  }

  /** What is wrong, and where; what was typed comes first. */
  Optional<Trouble> trouble() {
    return typed.or(
        () ->
            ports.state() instanceof PortsState.Closed closed
                    && !outdated.equals(Optional.of(closed))
                ? closed.trouble()
                : Optional.empty());
  }

  /** Whether the switch is on. */
  boolean on() {
    return !(ports.state() instanceof PortsState.Closed);
  }

  /** Whether the fields may be changed. */
  boolean changeable() {
    return !on();
  }

  /** One sentence about the ports. */
  String summary() {
    return switch (ports.state()) {
      case PortsState.Closed _ -> PortsTexts.text("closed");
      case PortsState.Opening _ -> PortsTexts.text("opening");
      case PortsState.Open open ->
          remote() ? clients(open) : PortsTexts.text("localControl", clients(open));
    };
  }

  private static String clients(PortsState.Open open) {
    int count = open.ports().stream().mapToInt(each -> each.port().connections().size()).sum();
    return switch (count) {
      case 0 -> PortsTexts.text("openNobodyIsConnected");
      case 1 -> PortsTexts.text("openOneClient");
      default -> PortsTexts.text("openClients", count);
    };
  }

  /** What the user should know before others come; empty for nothing. */
  String warning() {
    return ports.state() instanceof PortsState.Open open
        ? Stream.concat(exposure(open), missing(open)).collect(Collectors.joining("\n"))
        : "";
  }

  private static Stream<String> exposure(PortsState.Open open) {
    return open.exposed()
        ? Stream.of(PortsTexts.text("anyComputerThatReachesCanMove", open.address()))
        : Stream.empty();
  }

  /** One sentence for each of the first, as all may be taken by another controller. */
  private static Stream<String> missing(PortsState.Open open) {
    int more = open.missing().size() - MAX_MISSING;
    return Stream.concat(
        open.missing().stream().limit(MAX_MISSING).map(each -> each.why() + "."),
        more > 0 ? Stream.of(PortsTexts.text("soItIsWithMore", more)) : Stream.empty());
  }

  /** The open ports. */
  List<Row> rows() {
    return ports.state() instanceof PortsState.Open open
        ? open.ports().stream().map(PortsPresenter::row).toList()
        : List.of();
  }

  private static Row row(PortsState.OpenPort open) {
    TcpPort port = open.port();
    List<Connection> clients = port.connections();
    return new Row(
        open.controller().isEmpty() ? port.name() : Messages.told(open.controller(), port.name()),
        open.address() + ":" + port.number(),
        clients.size(),
        String.join(", ", clients.stream().map(PortsPresenter::who).sorted().toList()));
  }

  private static String who(Connection client) {
    return client.peer().getAddress().getHostAddress() + ":" + client.peer().getPort();
  }

  /** Whether clients may control the robot. */
  boolean remote() {
    return ports.state() instanceof PortsState.Open ? ports.remote() : remote;
  }

  /** Lets clients control the robot, or only ask. */
  void setRemote(boolean allowed) {
    remote = allowed;
    settings.put(REMOTE, Boolean.toString(allowed));
    ports.setRemote(allowed);
  }
}
