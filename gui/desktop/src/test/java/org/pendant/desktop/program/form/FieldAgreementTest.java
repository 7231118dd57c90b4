package org.pendant.desktop.program.form;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Modifier;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.form.Measure;
import org.pendant.project.program.FieldUnit;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.NodeField;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.NumberRange;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.check.NodeProblem;
import org.pendant.project.program.check.ProgramCheck;
import org.pendant.script.function.Builtins;

/** Every number that forms take, and what the check of programs says of it. */
@Tag("slow")
final class FieldAgreementTest {
  private final ControllerState state = new Controller(ControllerOptions.headless()).state();
  private final Installation installation = EveryNode.installation();
  private final Builtins<?> builtins = StandardBuiltins.create();

  /** No files. */
  private static final class NoFiles implements FormFiles {
    @Override
    public void choose(String title, String ending, Consumer<Path> chosen) {}

    @Override
    public void read(Path file, Consumer<String> text, Consumer<String> failed) {}
  }

  /** A node of a program. */
  private record Place(ProgramTree tree, long key) {
    ProgramNode node() {
      return tree.find(key).orElseThrow();
    }
  }

  /** A number in the form of a node. */
  private record FormNumber(Place place, Item.Quantity item) {
    NodeField field() {
      return item.field();
    }

    /** The program with another number there. */
    ProgramTree with(double value) {
      return item.edit().apply(OptionalDouble.of(value));
    }

    @Override
    public String toString() {
      return field().name() + " of " + place.node().step();
    }
  }

  private NodeForm form(Place place) {
    FakeHost host = new FakeHost(place.tree(), state);
    host.setInstallation(installation);
    FormPresenter presenter = new FormPresenter(host, new NoFiles());
    presenter.select(Optional.of(place.node()));
    return presenter.form().orElseThrow();
  }

  /** Every node, and every node as each choice in its form makes it. */
  private List<Place> places() {
    ProgramTree every = EveryNode.tree(state);
    List<Place> places = new ArrayList<>();
    for (ProgramNode node : every.nodes()) {
      Place place = new Place(every, node.key());
      places.add(place);
      for (Item item : form(place).items().toList()) {
        if (item instanceof Item.Choice choice) {
          choice
              .options()
              .forEach(
                  each -> places.add(new Place(choice.edit().apply(each.value()), node.key())));
        } else if (item instanceof Item.Check check) {
          places.add(new Place(check.edit().apply(!check.value()), node.key()));
        }
      }
    }
    return places;
  }

  /** Each field of each kind of node once. */
  private List<FormNumber> numbers() {
    Set<List<Object>> seen = new HashSet<>();
    List<FormNumber> numbers = new ArrayList<>();
    for (Place place : places()) {
      form(place)
          .items()
          .filter(Item.Quantity.class::isInstance)
          .map(Item.Quantity.class::cast)
          .filter(item -> seen.add(List.of(place.node().step().getClass(), item.field())))
          .forEach(item -> numbers.add(new FormNumber(place, item)));
    }
    return numbers;
  }

  /** The ends of a range, numbers next to them on both sides, and others. */
  private static Set<Double> values(NodeField field) {
    NumberRange range = field.range();
    Set<Double> values = new TreeSet<>(List.of(-1e6, -1.0, 0.0, 1.0, 3.0, 1e7));
    field.initial().ifPresent(values::add);
    if (!range.equals(NumberRange.ANY)) {
      for (double end : new double[] {range.min(), range.max()}) {
        boolean whole = field.unit() == FieldUnit.COUNT;
        values.add(whole ? end - 1 : Math.nextDown(end));
        values.add(end);
        values.add(whole ? end + 1 : Math.nextUp(end));
      }
    }
    return values;
  }

  /** What the check says of a number itself, not of what else it should fit to. */
  private String said(FormNumber number, double value) {
    String begin = number.field().words() + " is " + number.field().unit().words(value) + ", must";
    return ProgramCheck.problems(number.with(value), installation, builtins).stream()
        .filter(each -> each.key() == number.place().key())
        .filter(each -> each.field().equals(number.field().component()))
        .map(NodeProblem::message)
        .filter(each -> each.startsWith(begin))
        .distinct()
        .collect(Collectors.joining());
  }

  @Test
  void formsTakeExactlyTheNumbersThatTheCheckLetsRun() {
    for (FormNumber number : numbers()) {
      for (double value : values(number.field())) {
        String refusal = number.item().refusal(value);
        String expected =
            refusal.isEmpty()
                ? ""
                : number.field().words()
                    + " is "
                    + number.field().unit().words(value)
                    + ", "
                    + refusal;
        assertEquals(expected, said(number, value), () -> value + " for " + number);
      }
    }
  }

  @Test
  void formsShowTheUnitsThatTheCheckSpeaksOf() {
    for (FormNumber number : numbers()) {
      Measure shown = number.item().measure();
      FieldUnit told = number.field().unit();
      assertEquals(told.symbol(), shown.symbol(), number::toString);
      assertEquals(told.number(1), told.number(shown.parse(told.number(1))), number::toString);
    }
  }

  @Test
  void whatPeopleReadOfALimitCanBeTyped() {
    for (FormNumber number : numbers()) {
      NumberRange range = number.field().range();
      if (!range.equals(NumberRange.ANY)) {
        double typed = number.item().parse(number.item().measure().text(range.max()));
        assertEquals("", number.item().refusal(typed), number::toString);
      }
    }
  }

  @Test
  void everyFieldOfTheCatalogueIsInAForm() throws IllegalAccessException {
    Set<NodeField> shown = numbers().stream().map(FormNumber::field).collect(Collectors.toSet());
    for (var each : NodeFields.class.getFields()) {
      if (Modifier.isStatic(each.getModifiers()) && each.get(null) instanceof NodeField field) {
        assertTrue(shown.contains(field), each::getName);
      }
    }
  }

  @Test
  void casesTakeExactlyTheNumbersThatTheCheckLetsRun() {
    Place place =
        places().stream()
            .filter(each -> each.node().step() instanceof FlowStep.Case)
            .findFirst()
            .orElseThrow();
    Item.Text item = (Item.Text) form(place).item("value").orElseThrow();
    for (String text :
        List.of("1", "-1.5", " 2 ", "+3", ".5", "1.", "1e3", "x", "1,5", "0x10", "1 2", "e")) {
      boolean runs =
          ProgramCheck.problems(item.edit().apply(text), installation, builtins).stream()
              .noneMatch(each -> each.key() == place.key() && each.field().equals("value"));
      assertEquals(runs, item.refusal().apply(text).isEmpty(), text);
    }
  }
}
