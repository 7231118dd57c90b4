/**
 * Script ports: script text that clients send to the primary, secondary and real-time ports, cut
 * into programs, single statements and commands of the box, then compiled and run. Open {@link
 * org.pendant.protocols.script.ScriptHandler} first.
 */
package org.pendant.protocols.script;
