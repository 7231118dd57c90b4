package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.pendant.controller.device.DeviceField;
import org.pendant.controller.device.DeviceKind;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.wire.CellSignal;
import org.pendant.controller.wire.SignalGroup;
import org.pendant.kit.text.Messages;

/**
 * Cell wiring: what of the devices of a cell is wired to which signals of the controller;
 * immutable.
 *
 * @param boxes devices, and the rules if there are some
 */
record CellWiring(List<Box> boxes) {
  private static final String RULES = text("rules");
  private static final String ENCODER = "encoder";
  private static final int ENCODERS = 2;

  /** Signals of a group of a device that have rows. */
  private static final int MAX_SHOWN = 64;

  /** Of an encoder that is wired to a belt which did not say how many it has. */
  private static final double FIRST_TICKS_PER_M = 10_000;

  private static final Pattern RULE_PART =
      Pattern.compile("\"(when|while|set)\"\\s*:\\s*\"([^\"]*)\"");
  private static final Pattern SIGNAL = Pattern.compile("[\\w.-]+\\[\\d+]");

  /** Copies the list. */
  CellWiring {
    boxes = List.copyOf(boxes);
  }

  /**
   * A device.
   *
   * @param reached what programs reach it by besides, in words; empty for nothing
   */
  record Box(String name, String title, String reached, List<WirePort> ports) {
    /** Copies the list. */
    Box {
      ports = List.copyOf(ports);
    }
  }

  /**
   * Signals that stand beside each other.
   *
   * @param title what they are called together
   */
  record Group(String title, List<WireSignal> signals) {
    /** Copies the list. */
    Group {
      signals = List.copyOf(signals);
    }
  }

  /**
   * The wiring of a cell.
   *
   * @param rules as JSON
   */
  static CellWiring of(List<DeviceText> devices, String rules) {
    List<Box> boxes = new ArrayList<>();
    for (DeviceText device : devices) {
      DeviceKind.of(device.type()).ifPresent(kind -> boxes.add(box(device, kind)));
    }
    List<WirePort> ruled = ports(rules);
    if (!ruled.isEmpty()) {
      boxes.add(new Box(RULES, "", "", ruled));
    }
    return new CellWiring(boxes);
  }

  private static Box box(DeviceText device, DeviceKind kind) {
    List<WirePort> ports = new ArrayList<>();
    for (DeviceField field : kind.fields()) {
      if (field instanceof DeviceField.Wire wire) {
        ports.add(
            port(
                device,
                field,
                wire.input() ? WirePort.Way.TELLS : WirePort.Way.WATCHES,
                device.text(wire.key())));
      } else if (field.key().equals(ENCODER)) {
        OptionalDouble number = device.number(ENCODER);
        ports.add(
            port(
                device,
                field,
                WirePort.Way.TURNS,
                number.isPresent() ? encoder((int) number.getAsDouble()) : ""));
      }
    }
    return new Box(
        device.name(),
        Messages.shown(kind.title()),
        ports.isEmpty() ? Messages.shown(kind.reached()) : "",
        ports);
  }

  private static WirePort port(
      DeviceText device, DeviceField field, WirePort.Way way, String signal) {
    return new WirePort(
        device.name(),
        field.key(),
        Messages.shown(field.title()),
        Messages.shown(field.help()),
        way,
        field.required(),
        signal,
        false);
  }

  /** What rules watch and set. */
  private static List<WirePort> ports(String rules) {
    Set<WirePort> ports = new LinkedHashSet<>();
    Matcher parts = RULE_PART.matcher(rules);
    while (parts.find()) {
      boolean sets = parts.group(1).equals("set");
      Matcher signals = SIGNAL.matcher(parts.group(2));
      while (signals.find()) {
        String signal = signals.group();
        ports.add(
            new WirePort(
                RULES,
                text(sets ? "ruleSets" : "ruleWatches", signal),
                text(sets ? "sets" : "watches"),
                signal,
                sets ? WirePort.Way.TELLS : WirePort.Way.WATCHES,
                true,
                signal,
                true));
      }
    }
    return List.copyOf(ports);
  }

  private static String encoder(int number) {
    return ENCODER + "[" + number + "]";
  }

  /** What the controller has, inputs and outputs beside each other as on its box. */
  static List<Group> signals() {
    List<Group> groups = new ArrayList<>();
    for (SignalBank bank : SignalBank.values()) {
      if (bank != SignalBank.FLAG) {
        groups.add(
            group(
                title(bank),
                bank.text(),
                bank.size(),
                bank.input() ? WireSignal.Kind.INPUT : WireSignal.Kind.OUTPUT));
      }
    }
    groups.add(group(text("encoders"), ENCODER, ENCODERS, WireSignal.Kind.ENCODER));
    groups.add(
        group(text("flags"), SignalBank.FLAG.text(), SignalBank.FLAG.size(), WireSignal.Kind.FLAG));
    return groups;
  }

  /**
   * Digital signals of devices, which others are wired to; of many in a group the first ones.
   *
   * @param devices whose they are
   */
  static List<Group> signals(List<DeviceSetup> devices) {
    List<Group> groups = new ArrayList<>();
    for (DeviceSetup device : devices) {
      for (SignalGroup each : device.signals()) {
        if (each.digital()) {
          groups.add(group(device.name(), each));
        }
      }
    }
    return groups;
  }

  /**
   * Digital signals of the controllers of a cell by their own names, but those of the first, which
   * have none before them.
   *
   * @param controllers by their names; empty for one that is alone
   */
  static List<Group> ofControllers(List<String> controllers) {
    List<Group> groups = new ArrayList<>();
    for (String controller : controllers.stream().skip(1).toList()) {
      for (SignalBank bank : SignalBank.values()) {
        if (bank != SignalBank.FLAG) {
          groups.add(
              group(
                  Messages.told(controller, title(bank)),
                  controller + "." + bank.text(),
                  bank.size(),
                  bank.input() ? WireSignal.Kind.INPUT : WireSignal.Kind.OUTPUT));
        }
      }
    }
    return groups;
  }

  private static Group group(String owner, SignalGroup group) {
    WireSignal.Kind kind = group.settable() ? WireSignal.Kind.INPUT : WireSignal.Kind.OUTPUT;
    return new Group(
        Messages.told(owner, group.name()),
        IntStream.range(group.first(), group.first() + Math.min(MAX_SHOWN, group.count()))
            .mapToObj(i -> new CellSignal(owner, group.name(), i).toString())
            .map(name -> new WireSignal(name, kind))
            .toList());
  }

  private static Group group(String title, String name, int size, WireSignal.Kind kind) {
    return new Group(
        title,
        IntStream.range(0, size)
            .mapToObj(i -> new WireSignal(name + "[" + i + "]", kind))
            .toList());
  }

  private static String title(SignalBank bank) {
    return switch (bank) {
      case STANDARD_IN -> text("digitalInputs");
      case STANDARD_OUT -> text("digitalOutputs");
      case CONFIGURABLE_IN -> text("configurableInputs");
      case CONFIGURABLE_OUT -> text("configurableOutputs");
      case TOOL_IN -> text("toolInputs");
      case TOOL_OUT -> text("toolOutputs");
      case FLAG -> text("flags");
    };
  }

  /** All ports, in the order of their boxes. */
  List<WirePort> ports() {
    return boxes.stream().flatMap(each -> each.ports().stream()).toList();
  }

  /** Those at a signal. */
  List<WirePort> at(String signal) {
    return ports().stream().filter(each -> each.signal().equals(signal)).toList();
  }

  /**
   * What else sets an input that a port shall set, in words; empty for nothing. Such a wire can be:
   * the last one that changes counts.
   */
  String alsoSetBy(WirePort port, String signal) {
    return port.way() != WirePort.Way.TELLS
        ? ""
        : at(signal).stream()
            .filter(each -> each.way() == WirePort.Way.TELLS && !each.isAt(port))
            .findFirst()
            .map(other -> text("isAlsoSetBy", signal, other.device()))
            .orElse("");
  }

  /** Devices with the wire of a port at a signal; empty, the text, for no wire. */
  static List<DeviceText> wired(List<DeviceText> devices, WirePort port, String signal) {
    return devices.stream()
        .map(each -> each.name().equals(port.device()) ? wired(each, port, signal) : each)
        .toList();
  }

  private static DeviceText wired(DeviceText device, WirePort port, String signal) {
    if (port.way() != WirePort.Way.TURNS) {
      return device.withText(port.key(), signal);
    }
    OptionalDouble number =
        signal.isEmpty() ? OptionalDouble.empty() : OptionalDouble.of(number(signal));
    DeviceText next = device.withNumber(ENCODER, number);
    return number.isPresent() && next.number("ticks").isEmpty()
        ? next.withNumber("ticks", OptionalDouble.of(FIRST_TICKS_PER_M))
        : next;
  }

  private static int number(String encoder) {
    return Integer.parseInt(encoder.substring(encoder.indexOf('[') + 1, encoder.length() - 1));
  }

  /** The port at the same place in this wiring. */
  Optional<WirePort> now(WirePort before) {
    return ports().stream().filter(before::isAt).findFirst();
  }
}
