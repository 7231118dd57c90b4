package org.pendant.protocols.robotapi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.teachpendant.PendantSetup;
import org.pendant.protocols.teachpendant.ProgramStore;
import org.pendant.protocols.teachpendant.RemotePendant;

/** Programs go to the box and come back, as UR's client library sends them. */
class ProgramTransfersTest {
  @TempDir Path all;

  private final HttpClient client =
      HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
  private Path folder;
  private RunningBox box;
  private RemotePendant remotePendant;
  private RobotApiServer server;

  @BeforeEach
  void open() throws IOException {
    folder = Files.createDirectories(all.resolve("programs"));
    // nobody needs remote control to bring a program
    box = new RunningBox(ControllerOptions.headless(), new RemoteControl(true, false));
    remotePendant =
        new RemotePendant(
            box.controller(), new PendantSetup("ur5e", ProgramsFolder.at(folder), all));
    server = RobotApiServer.open(box.serverContext(), PortNumbers.anyFree(), remotePendant);
  }

  @AfterEach
  void close() {
    client.close();
    server.close();
    box.close();
  }

  private static String program(String name, String script) {
    return """
    {"application": {"urscript": {"script": ""}},
     "program": {"programInformation": {"name": "%s"},
       "programContent": {"contributedNode": {"type": "ur-program"}},
       "urscript": {"script": "%s"}}}
    """
        .formatted(name, script);
  }

  private HttpRequest.Builder request(String path) {
    return HttpRequest.newBuilder(
        URI.create(
            "http://127.0.0.1:"
                + server.ports().getFirst().number()
                + "/universal-robots/robot-api/programs/v1"
                + path));
  }

  private static HttpRequest.Builder form(HttpRequest.Builder to, String method, String content) {
    String body =
        "--Bound\r\nContent-Disposition: form-data; name=\"file\"; filename=\"filename\"\r\n"
            + "Content-Type: text/plain\r\n\r\n"
            + content
            + "\r\n--Bound--\r\n";
    return to.header("Content-Type", "multipart/form-data; boundary=Bound")
        .method(method, BodyPublishers.ofString(body));
  }

  private String send(HttpRequest request) throws IOException, InterruptedException {
    HttpResponse<String> answer =
        client.send(request, HttpResponse.BodyHandlers.ofString(StandardCharsets.UTF_8));
    assertEquals("application/json", answer.headers().firstValue("Content-Type").orElse(""));
    return answer.statusCode() + " " + answer.body();
  }

  private String post(String content) throws IOException, InterruptedException {
    return send(form(request("/"), "POST", content).build());
  }

  private String put(String content) throws IOException, InterruptedException {
    return send(form(request("/"), "PUT", content).build());
  }

  private String get(String name) throws IOException, InterruptedException {
    return send(request("/" + name).build());
  }

  private List<String> files() throws IOException {
    try (Stream<Path> files = Files.walk(all)) {
      return files
          .filter(each -> !Files.isDirectory(each))
          .map(each -> all.relativize(each).toString())
          .sorted()
          .toList();
    }
  }

  @Test
  void aProgramIsAddedListedLoadedAndGivenBack() throws Exception {
    String pick = program("test caf\u00e9+", "textmsg(1)");
    assertEquals(
        "200 {\"programName\":\"test caf\u00e9+\",\"message\":\"the program is added\"}",
        post(pick));
    assertTrue(get("").contains("\"name\":\"test caf\u00e9+\""), get(""));
    assertEquals("200 " + pick, get("test%20caf%C3%A9+"));
    assertEquals("200 " + pick, get("test%20caf%c3%a9%2B/"));
    assertEquals(List.of("programs/test caf\u00e9+.urpx"), files());
    String name =
        new String("test caf\u00e9+".getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
    assertTrue(
        remotePendant
            .loadNamed(name)
            .program()
            .orElseThrow()
            .source()
            .text()
            .contains("textmsg(1)"));
  }

  @Test
  void aProgramThatIsThereIsReplacedOnlyByPut() throws Exception {
    assertEquals(
        "404 {\"message\":\"Program not found\",\"details\":\"pick is not there, with none of the"
            + " endings .pendant, .urp, .script, .urpx\"}",
        put(program("pick", "x = 1")));
    assertTrue(post(program("pick", "x = 1")).startsWith("200 "));
    assertEquals(
        "400 {\"message\":\"Program already exists\",\"details\":\"pick is there already, as"
            + " pick.urpx\"}",
        post(program("pick", "x = 2")));
    assertEquals("200 " + program("pick", "x = 1"), get("pick"));
    assertEquals(
        "200 {\"programName\":\"pick\",\"message\":\"the program is replaced\"}",
        put(program("pick", "x = 2")));
    assertEquals("200 " + program("pick", "x = 2"), get("pick"));
  }

  @Test
  void programsInOtherFormsAreNeitherHiddenReplacedNorGiven() throws Exception {
    Files.writeString(folder.resolve("pick.script"), "x = 1");
    assertEquals(
        "400 {\"message\":\"Program already exists\",\"details\":\"pick is there already, as"
            + " pick.script\"}",
        post(program("pick", "x = 2")));
    String other =
        "409 {\"message\":\"Not possible now\",\"details\":\"pick is pick.script, which is no"
            + " program of PolyScope X\"}";
    assertEquals(other, put(program("pick", "x = 2")));
    assertEquals(other, get("pick"));
    assertEquals(List.of("programs/pick.script"), files());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        " ",
        "../pick",
        "/etc/pick",
        "a/b",
        "a\\\\b",
        "C:pick",
        "..",
        ".hidden",
        "dot.",
        " blank",
        "pick.script",
        "new\\nline",
        "nul\\u0000",
        "half\\ud800"
      })
  void aNameThatIsNoneOfAFileInTheFolderIsRefused(String name) throws Exception {
    String answer = post(program(name, "x = 1"));
    if (!name.startsWith("half")) {
      assertTrue(
          answer.startsWith(
              "422 {\"message\":\"Validation Error\",\"details\":\"the name of the program must"),
          answer);
    }
    assertEquals(answer.startsWith("200 ") ? 1 : 0, files().size());
  }

  @Test
  void aClientMayHoldTheProgramBackUntilItIsWelcome() throws Exception {
    String answer =
        send(form(request("/").expectContinue(true), "POST", program("pick", "x = 1")).build());
    assertTrue(answer.startsWith("200 "), answer);
  }

  @Test
  void aNameIsAtMostAsLongAsThoseOfFiles() throws Exception {
    assertTrue(post(program("x".repeat(200), "x = 1")).startsWith("200 "));
    assertTrue(
        post(program("\u00e9".repeat(101), "x = 1"))
            .contains("the name of the program has 202 bytes, must have at most 200"));
  }

  @Test
  void whatIsNoProgramIsNotTaken() throws Exception {
    String broken = post("{\n \"program\": }");
    assertTrue(
        broken.startsWith(
            "422 {\"message\":\"Validation Error\",\"details\":\"file:2:13: is no JSON: "),
        broken);
    assertTrue(
        post(program("pick", "x = 1").replace("\"programInformation\"", "\"other\""))
            .contains("programInformation is missing, must be an object"));
    assertTrue(
        post(program("pick", "x = 1").replace("{\"name\": \"pick\"}", "{}"))
            .contains("says no name: programInformation must have one"));
    String plain =
        send(
            request("/")
                .header("Content-Type", "application/json")
                .POST(BodyPublishers.ofString(program("pick", "x = 1")))
                .build());
    assertEquals(
        "422 {\"message\":\"Validation Error\",\"details\":\"the body must be multipart/form-data"
            + " with a part \\\"file\\\"\"}",
        plain);
    assertEquals(List.of(), files());
  }

  @Test
  void aProgramThatIsTooLargeIsRefusedAndTheConnectionGoesOn() throws Exception {
    String empty = program("pick", "");
    String filler = "#".repeat(ProgramStore.MAX_BYTES - empty.length());
    String refused =
        "413 {\"message\":\"Program too large\",\"details\":\"a program may have at most 1000000"
            + " bytes\"}";
    assertEquals(refused, post(program("pick", filler + "#")));
    assertEquals(refused, post("x".repeat(5_000_000)));
    assertEquals(List.of(), files());
    assertTrue(post(program("pick", filler)).startsWith("200 "));
    assertEquals("200 " + program("pick", filler), get("pick"));
    Files.writeString(folder.resolve("pick.urpx"), program("pick", filler + "#"));
    assertTrue(get("pick").contains("is too large, must have at most 1000000 bytes"), get("pick"));
  }

  @Test
  void linksLeadNobodyOutOfTheFolder() throws Exception {
    Path outside = all.resolve("outside.urpx");
    Files.writeString(outside, program("link", "x = 1"));
    Files.createSymbolicLink(folder.resolve("link.urpx"), outside);
    Files.createSymbolicLink(folder.resolve("nowhere.urpx"), all.resolve("new.urpx"));
    String leadsOut =
        "409 {\"message\":\"Not possible now\",\"details\":\"link.urpx is a link that leads out of"
            + " the programs folder\"}";
    assertEquals(leadsOut, put(program("link", "x = 2")));
    assertEquals(leadsOut, get("link"));
    assertTrue(post(program("nowhere", "x = 2")).startsWith("400 "));
    assertTrue(put(program("nowhere", "x = 2")).startsWith("409 "));
    assertFalse(Files.exists(all.resolve("new.urpx")));
    assertEquals(program("link", "x = 1"), Files.readString(outside));
  }

  @Test
  void namesInPathsLeadNowhereElse() throws Exception {
    Files.writeString(all.resolve("outside.urpx"), program("outside", "x = 1"));
    for (String name : List.of("none", "..%2Foutside", "%2e%2e%2foutside", "%00", "outside.urpx")) {
      assertTrue(get(name).startsWith("404 {\"message\":\"Program not found\""), get(name));
    }
    assertTrue(get("a/b").startsWith("404 {\"message\":\"Not Found\""), get("a/b"));
  }

  @Test
  void thereAreNoMoreProgramsThanAreListed() throws Exception {
    for (int i = 0; i < 1000; i++) {
      Files.createFile(folder.resolve("p" + i + ".script"));
    }
    assertEquals(
        "409 {\"message\":\"Not possible now\",\"details\":\"the programs folder has 1000 programs,"
            + " which are the most\"}",
        post(program("pick", "x = 1")));
  }

  @Test
  void pagesInABrowserNeitherBringNorGetPrograms() throws Exception {
    assertTrue(post(program("pick", "x = 1")).startsWith("200 "));
    for (HttpRequest.Builder each :
        List.of(
            form(request(""), "POST", program("other", "x = 1")),
            form(request(""), "PUT", program("pick", "x = 2")),
            request("/pick"))) {
      assertTrue(
          send(each.header("Origin", "http://127.0.0.1").build()).startsWith("403 "), "web page");
    }
    assertEquals("200 " + program("pick", "x = 1"), get("pick"));
  }

  @Test
  void otherMethodsAreRefusedWithThoseThatThereAre() throws Exception {
    assertTrue(send(request("/pick").DELETE().build()).endsWith("\"details\":\"must be GET\"}"));
    assertTrue(
        send(request("").DELETE().build()).endsWith("\"details\":\"must be GET or POST or PUT\"}"));
  }
}
