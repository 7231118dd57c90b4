package org.pendant.desktop.plot;

import static org.pendant.desktop.plot.PlotTexts.text;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.quantity.Component;
import org.pendant.controller.quantity.PhysicalUnit;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.workbench.ScreenUnit;
import org.pendant.kit.text.Messages;
import org.pendant.text.Language;

/** Chart quantities: what can be drawn, in the order of the list; script variables come first. */
public final class ChartQuantities {
  /** The group of what joints have, in English as the controller says it. */
  static final String JOINTS = "Joints";

  /** The group of what the TCP has, in English as the controller says it. */
  static final String TCP = "TCP";

  private static final double MA_PER_A = 1e3;

  private final Map<String, ChartQuantity> byId = new LinkedHashMap<>();
  private final ScriptVariables variables = new ScriptVariables();

  /** What every controller has. */
  public static ChartQuantities standard() {
    return standard(signal -> "");
  }

  /**
   * What every controller has.
   *
   * @param names what people call a signal, by an id such as {@code digital-in-0}; empty text for
   *     none
   */
  public static ChartQuantities standard(Function<String, String> names) {
    ChartQuantities all = new ChartQuantities();
    StateQuantities.all().forEach(each -> all.addAll(each, names));
    return all;
  }

  /**
   * Adds one.
   *
   * @throws IllegalArgumentException if there is one of this id already
   */
  public void add(ChartQuantity quantity) {
    if (byId.putIfAbsent(quantity.id(), quantity) != null) {
      throw new IllegalArgumentException("quantity " + quantity.id() + " is there already");
    }
  }

  /** All of them. */
  public List<ChartQuantity> all() {
    return Stream.concat(variables.all().stream(), byId.values().stream()).toList();
  }

  /** The one called {@code id}; script variables are found also while no program has them. */
  public Optional<ChartQuantity> find(String id) {
    ChartQuantity present = byId.get(id);
    return present == null ? variables.find(id) : Optional.of(present);
  }

  ScriptVariables variables() {
    return variables;
  }

  /**
   * Those whose texts have every word of {@code text}, upper and lower case alike; without words
   * all but those that {@link ScriptVariables#hide} leaves out.
   */
  public List<ChartQuantity> search(String text) {
    if (text.isBlank()) {
      return all().stream().filter(each -> !variables.hides(each)).toList();
    }
    String[] words = text.strip().toLowerCase(Locale.ROOT).split("\\s+");
    return all().stream().filter(each -> hasAll(each, words)).toList();
  }

  private static boolean hasAll(ChartQuantity quantity, String[] words) {
    String text =
        (quantity.group()
                + " "
                + quantity.namedTitle()
                + " "
                + quantity.id()
                + " "
                + quantity.hint())
            .toLowerCase(Locale.ROOT);
    for (String word : words) {
      if (!text.contains(word)) {
        return false;
      }
    }
    return true;
  }

  private void addAll(StateQuantity state, Function<String, String> names) {
    for (int i = 0; i < state.size(); i++) {
      Component component = state.components().get(i);
      String id = component.name();
      ScreenUnit unit = ScreenUnit.of(component.unit());
      add(
          new ChartQuantity(
              id,
              shownGroup(state.group()),
              Messages.shown(component.title()),
              label(state.group(), component.title()),
              unit.symbol(),
              value(state, i, unit.scale()),
              () -> names.apply(id.replace('_', '-')),
              hint(state)));
    }
  }

  private static ToDoubleFunction<ControllerState> value(
      StateQuantity quantity, int index, double scale) {
    ToDoubleFunction<ControllerState> value = quantity.getter().element(index);
    if (quantity.components().get(index).unit() != PhysicalUnit.AMPERE_OR_VOLT) {
      return state -> scale * value.applyAsDouble(state);
    }
    ToDoubleFunction<ControllerState> domain =
        StateQuantities.of(quantity.name() + "_domain").getter().element(index);
    return state ->
        domain.applyAsDouble(state) == AnalogDomain.CURRENT.number()
            ? MA_PER_A * value.applyAsDouble(state)
            : value.applyAsDouble(state);
  }

  /** A group in the language of the window, level by level. */
  private static String shownGroup(String group) {
    return Stream.of(group.split("/")).map(Messages::shown).collect(Collectors.joining("/"));
  }

  /** Titles of signals say enough alone, and those of quantities without others beside them. */
  private static String label(String group, String title) {
    int slash = group.indexOf('/');
    String top = slash < 0 ? group : group.substring(0, slash);
    if (slash < 0 || top.equals("Signals") || top.equals("Registers")) {
      return Messages.shown(title);
    }
    Language language = Language.ofProcess();
    String of = Messages.shown(group.substring(slash + 1));
    String component = Messages.shown(title);
    return top.equals(JOINTS)
        ? text("ofJoint", of, language.withinSentence(component))
        : text("ofGroup", Messages.shown(top), language.withinSentence(of), component);
  }

  private static String hint(StateQuantity quantity) {
    List<String> fields = quantity.fieldEach() ? List.of() : quantity.rtdeNames();
    return Stream.concat(
            Stream.of(Messages.shown(quantity.explanation())).filter(text -> !text.isEmpty()),
            fields.stream().map(name -> "RTDE: " + name))
        .collect(Collectors.joining("; "));
  }
}
