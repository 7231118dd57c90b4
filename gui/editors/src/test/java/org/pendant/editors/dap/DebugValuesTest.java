package org.pendant.editors.dap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.editors.dap.DebugClient.refusal;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.eclipse.lsp4j.debug.CompletionItem;
import org.eclipse.lsp4j.debug.CompletionsArguments;
import org.eclipse.lsp4j.debug.EvaluateResponse;
import org.eclipse.lsp4j.debug.InitializeRequestArguments;
import org.eclipse.lsp4j.debug.SetExpressionArguments;
import org.eclipse.lsp4j.debug.SetVariableArguments;
import org.eclipse.lsp4j.debug.Variable;
import org.eclipse.lsp4j.debug.VariablesArguments;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DebugValuesTest {
  private static final String VALUES =
      """
      count = 3
      word = "grün"
      part = struct(size=2, at=p[0.1, 0.2, 0.3, 0, 0, 0])
      numbers = make_list(2500, 7, 2500)
      def half(x):
        return x / 2
      end
      sleep(0.1)
      textmsg(count * 1000 + numbers[2400])
      """;

  @TempDir private Path folder;

  private DebugClient stopped() throws Exception {
    DebugClient client = DebugClient.of(folder, VALUES);
    client.launch();
    var _ = client.breakpoints(8);
    client.configured();
    client.stop();
    return client;
  }

  private static List<String> texts(List<Variable> all) {
    return all.stream().map(each -> each.getName() + " = " + each.getValue()).toList();
  }

  private static Variable global(DebugClient client, String name) {
    return client.variables(client.scopes().get("Globals").getVariablesReference()).stream()
        .filter(each -> each.getName().equals(name))
        .findFirst()
        .orElseThrow();
  }

  private static List<Variable> page(DebugClient client, int reference, int start, int count) {
    VariablesArguments arguments = new VariablesArguments();
    arguments.setVariablesReference(reference);
    arguments.setStart(start);
    arguments.setCount(count);
    return List.of(client.server().variables(arguments).join().getVariables());
  }

  private static String set(DebugClient client, int reference, String name, String value) {
    SetVariableArguments arguments = new SetVariableArguments();
    arguments.setVariablesReference(reference);
    arguments.setName(name);
    arguments.setValue(value);
    return client.server().setVariable(arguments).join().getValue();
  }

  @Test
  void expressionsAreComputedInTheCallThatIsLookedAt() throws Exception {
    try (DebugClient client = stopped()) {
      assertEquals("4", client.evaluate("count + 1", "watch"));
      assertEquals("\"grün\"", client.evaluate("word", "hover"));
      assertEquals("1.5", client.evaluate("half(count)", "repl"));
      EvaluateResponse list =
          client.server().evaluate(client.evaluation("numbers", "watch")).join();
      assertEquals("list", list.getType());
      assertEquals(2500, list.getIndexedVariables());
    }
  }

  @Test
  void whatCannotBeComputedIsRefusedWithTheReason() throws Exception {
    try (DebugClient client = stopped()) {
      assertTrue(
          refusal(client.server().evaluate(client.evaluation("nothing + 1", "watch")))
              .contains("nothing"));
      assertTrue(
          refusal(client.server().evaluate(client.evaluation("sleep(1)", "repl")))
              .contains("sleep"));
      assertEquals(
          "what calls a function is not computed when the pointer rests on it",
          refusal(client.server().evaluate(client.evaluation("half(1)", "hover"))));
    }
  }

  @Test
  void longValuesComeInParts() throws Exception {
    try (DebugClient client = stopped()) {
      int numbers = global(client, "numbers").getVariablesReference();
      assertEquals(List.of("[2400] = 7", "[2401] = 7"), texts(page(client, numbers, 2400, 2)));
      assertEquals(1000, page(client, numbers, 0, 0).size());
      assertEquals(List.of(), page(client, numbers, 5000, 10));
    }
  }

  @Test
  void aClientThatKnowsNoPagesGetsAPartForEachThousand() throws Exception {
    try (DebugClient client = DebugClient.of(folder, VALUES)) {
      client.server().initialize(new InitializeRequestArguments()).join();
      String program = folder.resolve("program.script").toString();
      client.server().launch(Map.of("program", program)).join();
      var _ = client.breakpoints(8);
      client.configured();
      client.stop();
      List<Variable> parts = client.variables(global(client, "numbers").getVariablesReference());
      assertEquals(
          List.of("[0 to 999]", "[1000 to 1999]", "[2000 to 2499]"),
          parts.stream().map(Variable::getName).toList());
      List<Variable> last = client.variables(parts.getLast().getVariablesReference());
      assertEquals("[2499] = 7", texts(last).getLast());
      assertEquals(500, last.size());
    }
  }

  @Test
  void membersAndElementsAreLookedAt() throws Exception {
    try (DebugClient client = stopped()) {
      Variable part = global(client, "part");
      assertEquals("struct", part.getType());
      List<Variable> members = client.variables(part.getVariablesReference());
      assertEquals("size = 2", texts(members).getFirst());
      assertEquals("part.at", members.get(1).getEvaluateName());
      assertEquals(
          "[1] = 0.2", texts(client.variables(members.get(1).getVariablesReference())).get(1));
    }
  }

  @Test
  void variablesTakeNewValues() throws Exception {
    try (DebugClient client = stopped()) {
      int globals = client.scopes().get("Globals").getVariablesReference();
      assertEquals("12", set(client, globals, "count", "count * 4"));
      int numbers = global(client, "numbers").getVariablesReference();
      assertEquals("9", set(client, numbers, "[2400]", "9"));
      assertEquals("5", client.evaluate("part.size = 5", "repl"));
      SetExpressionArguments expression = new SetExpressionArguments();
      expression.setExpression("part.size");
      expression.setValue("6");
      expression.setFrameId(client.top().getId());
      assertEquals("6", client.server().setExpression(expression).join().getValue());
      client.resume();
      assertEquals(0, client.end());
      assertEquals("12009\n", client.said("stdout"));
    }
  }

  @Test
  void aValueOfAnotherTypeIsRefusedAndNothingChanges() throws Exception {
    try (DebugClient client = stopped()) {
      assertTrue(
          refusal(client.server().evaluate(client.evaluation("count = \"x\"", "repl")))
              .contains("count"));
      assertEquals("3", client.evaluate("count", "watch"));
      int robot = client.scopes().get("Robot").getVariablesReference();
      SetVariableArguments arguments = new SetVariableArguments();
      arguments.setVariablesReference(robot);
      arguments.setName("time");
      arguments.setValue("1");
      assertEquals(
          "time cannot be changed from here", refusal(client.server().setVariable(arguments)));
    }
  }

  @Test
  void numbersOfACallDoNotOutliveTheStop() throws Exception {
    try (DebugClient client = stopped()) {
      int globals = client.scopes().get("Globals").getVariablesReference();
      client.stepOver();
      client.stop();
      VariablesArguments arguments = new VariablesArguments();
      arguments.setVariablesReference(globals);
      assertEquals(
          "there are no variables " + globals + " any more: the program has gone on",
          refusal(client.server().variables(arguments)));
    }
  }

  @Test
  void whatIsTypedIsCompleted() throws Exception {
    try (DebugClient client = stopped()) {
      CompletionsArguments arguments = new CompletionsArguments();
      arguments.setText("1 + coun");
      arguments.setColumn(9);
      arguments.setFrameId(client.top().getId());
      CompletionItem[] offered = client.server().completions(arguments).join().getTargets();
      assertEquals("count", offered[0].getText());
      assertEquals(5, offered[0].getStart());
      assertEquals(4, offered[0].getLength());
      arguments.setText("part.");
      arguments.setColumn(6);
      assertEquals(
          List.of("at", "size"),
          Arrays.stream(client.server().completions(arguments).join().getTargets())
              .map(CompletionItem::getLabel)
              .filter(List.of("at", "size")::contains)
              .sorted()
              .toList());
    }
  }
}
