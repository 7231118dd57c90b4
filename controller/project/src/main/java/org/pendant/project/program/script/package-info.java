/**
 * Script generation: the script that a program tree runs as. Open {@link
 * org.pendant.project.program.script.GeneratedScript} first.
 */
package org.pendant.project.program.script;
