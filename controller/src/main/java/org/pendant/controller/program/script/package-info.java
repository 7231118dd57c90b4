/**
 * The script that a program tree runs as. Open {@link
 * org.pendant.controller.program.script.GeneratedScript} first.
 */
package org.pendant.controller.program.script;
