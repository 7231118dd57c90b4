/** What all packages say to people: whole in every language, and nothing of it in code. */
package org.pendant.text;
