package org.pendant.command;

import static java.nio.charset.StandardCharsets.UTF_8;
import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.OutputStream;
import java.lang.classfile.ClassFile;
import java.lang.classfile.CodeElement;
import java.lang.classfile.instruction.InvokeDynamicInstruction;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.jar.Attributes;
import java.util.jar.Attributes.Name;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.text.Texts;

/** What the launcher makes of the jars that were built. */
@Tag("slow") // compiles the rewriting, which is a source of the build
class StartableJarsTest {
  @TempDir static Path tool;
  @TempDir Path folder;

  @BeforeAll
  static void compile() {
    Path build = Path.of(System.getProperty("pendant.home"), ".build");
    String[] options = {"-proc:none", "-d", tool.toString(), "-sourcepath", build.toString()};
    String source = build.resolve("StartableJars.java").toString();
    int code =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                null,
                Stream.concat(Stream.of(options), Stream.of(source)).toArray(String[]::new));
    assertEquals(0, code);
  }

  /** A record with components of every kind. */
  record Everything(
      boolean z, byte b, short s, char c, int i, long j, float f, double d, String text) {}

  /** A closed family. */
  sealed interface Shape permits Disc, Box, Point {}

  record Disc(double radius) implements Shape {}

  record Box(int width, int height) implements Shape {}

  record Point() implements Shape {}

  /** Says of values what pattern switches, {@code equals} and {@code hashCode} make of them. */
  public static final class Sample implements Function<Integer, List<Object>> {
    @Override
    public List<Object> apply(Integer number) {
      double odd = List.of(0.0, -0.0, Double.NaN, 1.5).get(number % 4);
      Everything one = new Everything(true, (byte) 1, (short) 2, 'c', 3, 4, (float) odd, odd, null);
      Everything other =
          new Everything(true, (byte) 1, (short) 2, 'c', 3, 4, (float) odd, 0.0, null);
      return List.of(
          one.hashCode(),
          one.equals(other),
          List.<Object>of(one).equals(List.of(new Point())),
          new Point().equals(new Point()),
          new Box(number, 2).equals(new Box(2, number)),
          new Box(number, 2).hashCode(),
          name(new Disc(number)),
          name(new Box(number, 2)),
          name(new Point()),
          kind(null),
          kind("text"),
          kind(number));
    }

    private static String name(Shape shape) {
      return switch (shape) {
        case Box box when box.width() > 2 -> "wide";
        case Box box when box.width() > 1 -> "box";
        case Disc(double radius) when radius > 1 -> "big";
        case Disc disc -> "disc";
        case Box box -> "narrow";
        case Point point -> "point";
      };
    }

    private static String kind(Object object) {
      return switch (object) {
        case null -> "nothing";
        case CharSequence text -> "text";
        default -> "something";
      };
    }
  }

  @Test
  void switchesAndRecordsDoTheSameInRewrittenJars() throws Exception {
    rewrite(jar("META-INF/MANIFEST.MF"));
    try (URLClassLoader rewritten =
        new URLClassLoader(new URL[] {folder.resolve("some.jar").toUri().toURL()}, null)) {
      @SuppressWarnings("unchecked") // it is the class above, loaded once more
      Function<Integer, List<Object>> sample =
          (Function<Integer, List<Object>>)
              rewritten.loadClass(Sample.class.getName()).getConstructor().newInstance();
      for (int i = 0; i < 4; i++) {
        assertEquals(new Sample().apply(i), sample.apply(i), "sample " + i);
      }
    }
  }

  @Test
  void rewrittenClassesLeaveNothingToBeMadeAtTheStart() throws Exception {
    rewrite(jar("META-INF/MANIFEST.MF"));
    try (JarFile jar = new JarFile(folder.resolve("some.jar").toFile())) {
      for (Class<?> type : List.of(Sample.class, Box.class)) {
        byte[] content = jar.getInputStream(jar.getEntry(file(type))).readAllBytes();
        assertFalse(
            ClassFile.of().parse(content).methods().stream()
                .flatMap(method -> method.code().stream())
                .flatMap(code -> code.elementStream())
                .anyMatch(StartableJarsTest::isMadeLater),
            type.getName());
      }
    }
  }

  @Test
  void textsOfAllJarsAreInClassesAndTheirFilesAreGone() throws Exception {
    String type = "org/pendant/text/CompiledTexts.class";
    write("text.jar", Map.of(type, Texts.class.getResourceAsStream("/" + type).readAllBytes()));
    write(
        "other.jar",
        Map.of(
            "texts/some.log.properties",
                bytes("stopped = stopped at {0}\nb = \nlong = " + "x".repeat(9000)),
            "texts/some.log_de.properties", bytes("stopped = gestoppt bei {0}, größer"),
            "texts/bundles.txt", bytes("some.log")));
    // two names with one hash code
    write(
        "AaAa.jar",
        Map.of("texts/AaBB.properties", bytes("k = 1"), "texts/BBAa.properties", bytes("k = 2")));

    rewrite(folder.resolve("text.jar"));

    try (URLClassLoader rewritten =
        new URLClassLoader(new URL[] {folder.resolve("text.jar").toUri().toURL()}, null)) {
      Method find =
          rewritten
              .loadClass("org.pendant.text.CompiledTexts")
              .getDeclaredMethod("of", String.class);
      find.setAccessible(true);
      assertEquals(
          List.of("b", "", "long", "x".repeat(9000), "stopped", "stopped at {0}"),
          List.of((Object[]) find.invoke(null, "some.log")));
      assertEquals(
          List.of("stopped", "gestoppt bei {0}, größer"),
          List.of((Object[]) find.invoke(null, "some.log_de")));
      assertEquals(List.of("k", "1"), List.of((Object[]) find.invoke(null, "AaBB")));
      assertEquals(List.of("k", "2"), List.of((Object[]) find.invoke(null, "BBAa")));
      assertEquals(List.of(), List.of((Object[]) find.invoke(null, "some.log_zh")));
    }
    try (JarFile jar = new JarFile(folder.resolve("other.jar").toFile())) {
      assertEquals(List.of("texts/bundles.txt"), jar.stream().map(JarEntry::getName).toList());
    }
  }

  @Test
  void fontsLieInJarsAsTheyAre() throws Exception {
    write(
        "fonts.jar",
        Map.of("Some.otf", bytes("a".repeat(1000)), "some.txt", bytes("a".repeat(1000))));

    rewrite(folder.resolve("fonts.jar"));

    try (JarFile jar = new JarFile(folder.resolve("fonts.jar").toFile())) {
      assertEquals(ZipEntry.STORED, jar.getEntry("Some.otf").getMethod());
      assertEquals(ZipEntry.DEFLATED, jar.getEntry("some.txt").getMethod());
      assertEquals(
          "a".repeat(1000),
          new String(jar.getInputStream(jar.getEntry("Some.otf")).readAllBytes(), UTF_8));
    }
  }

  @Test
  void signaturesAreTakenOutOfJars() throws Exception {
    rewrite(jar("META-INF/SIGNER.SF", "META-INF/SIGNER.RSA", "META-INF/NOTICE"));
    try (JarFile jar = new JarFile(folder.resolve("some.jar").toFile())) {
      assertEquals(
          List.of("META-INF/NOTICE"),
          jar.stream().map(JarEntry::getName).filter(name -> name.startsWith("META-INF")).toList());
    }
  }

  @Test
  void ofManifestsRemainsWhatIsAskedFor() throws Exception {
    Manifest manifest = new Manifest();
    Attributes attributes = manifest.getMainAttributes();
    for (Name kept :
        List.of(Name.MANIFEST_VERSION, Name.MULTI_RELEASE, Name.IMPLEMENTATION_VERSION)) {
      attributes.put(kept, "1.0");
    }
    Attributes needed = new Attributes(attributes);
    attributes.put(new Name("Export-Package"), "some");
    manifest.getEntries().put("some/Some.class", new Attributes(needed));
    Path file = folder.resolve("some.jar");
    new JarOutputStream(Files.newOutputStream(file), manifest).close();

    rewrite(file);

    try (JarFile jar = new JarFile(file.toFile())) {
      assertEquals(needed, jar.getManifest().getMainAttributes());
      assertEquals(Map.of(), jar.getManifest().getEntries());
    }
  }

  @Test
  void theJarThatIsStartedHasOnlyAClassPathWithTheArmsFirst() throws Exception {
    Path lib = Files.createDirectory(folder.resolve("lib"));
    String[] names = {"some.jar", "pendant-models-1.jar", "others.jar"};
    Manifest manifest = new Manifest();
    manifest.getMainAttributes().put(Name.MANIFEST_VERSION, "1.0");
    for (String name : names) {
      new JarOutputStream(Files.newOutputStream(lib.resolve(name)), manifest).close();
    }
    manifest.getMainAttributes().put(Name.MAIN_CLASS, "some.Main");
    manifest
        .getMainAttributes()
        .put(Name.CLASS_PATH, Stream.of(names).map("lib/"::concat).collect(joining(" ")));
    Path start = folder.resolve("pendant.jar");
    JarEntry dated = new JarEntry(JarFile.MANIFEST_NAME);
    dated.setTime(1_000_000_000_000L);
    try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(start))) {
      out.putNextEntry(dated);
      manifest.write(out);
      out.putNextEntry(new JarEntry("word.txt"));
      out.write('w');
    }

    rewrite(start);

    try (JarFile jar = new JarFile(start.toFile());
        JarFile desktop = new JarFile(lib.resolve("pendant-desktop.jar").toFile())) {
      Attributes attributes = jar.getManifest().getMainAttributes();
      assertEquals("some.Main", attributes.getValue(Name.MAIN_CLASS));
      assertEquals(
          "lib/pendant-models-1.jar lib/pendant-desktop.jar lib/some.jar lib/others.jar",
          attributes.getValue(Name.CLASS_PATH));
      assertEquals(List.of(JarFile.MANIFEST_NAME), jar.stream().map(JarEntry::getName).toList());
      assertFalse(desktop.getManifest().getMainAttributes().containsKey(Name.CLASS_PATH));
      // Made later, they are the same.
      assertEquals(dated.getTime(), jar.getEntry(JarFile.MANIFEST_NAME).getTime());
      assertEquals(dated.getTime(), desktop.getEntry(JarFile.MANIFEST_NAME).getTime());
    }
    try (URLClassLoader started = new URLClassLoader(new URL[] {start.toUri().toURL()}, null)) {
      assertEquals('w', started.getResourceAsStream("word.txt").read());
    }
  }

  private static boolean isMadeLater(CodeElement element) {
    return element instanceof InvokeDynamicInstruction call
        && !call.name().equalsString("toString")
        && !call.bootstrapMethod().owner().displayName().equals("StringConcatFactory");
  }

  private void write(String jar, Map<String, byte[]> entries) throws Exception {
    try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(folder.resolve(jar)))) {
      for (Map.Entry<String, byte[]> each : entries.entrySet()) {
        out.putNextEntry(new JarEntry(each.getKey()));
        out.write(each.getValue());
      }
    }
  }

  private static byte[] bytes(String text) {
    return text.getBytes(UTF_8);
  }

  private Path jar(String... others) throws Exception {
    Path file = folder.resolve("some.jar");
    try (OutputStream bytes = Files.newOutputStream(file);
        JarOutputStream out = new JarOutputStream(bytes)) {
      for (String name : others) {
        out.putNextEntry(new JarEntry(name));
      }
      for (Class<?> type :
          Stream.of(Sample.class, Everything.class, Shape.class, Disc.class, Box.class, Point.class)
              .toList()) {
        out.putNextEntry(new JarEntry(file(type)));
        out.write(type.getResourceAsStream("/" + file(type)).readAllBytes());
      }
    }
    return file;
  }

  private static String file(Class<?> type) {
    return type.getName().replace('.', '/') + ".class";
  }

  private static void rewrite(Path jar) throws Exception {
    try (URLClassLoader build = new URLClassLoader(new URL[] {tool.toUri().toURL()})) {
      Method main = build.loadClass("StartableJars").getDeclaredMethod("main", String[].class);
      main.setAccessible(true);
      main.invoke(null, (Object) new String[] {jar.getParent().toString()});
    }
  }
}
