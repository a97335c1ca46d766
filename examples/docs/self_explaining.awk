# Doxygen reads the headers through this. Members whose name says what they are get their sentence
# here, once for all classes; everything else that is public has to be documented where it stands.
function say(sentence) {
  if (!documented) sub(/^ */, "&/** " sentence " */ ")
}

/operator(==|!=)\(const/ { say("Member by member.") }
/operator<\(const/ { say("Lexicographic: a total order.") }
/operator=\(const|^  [A-Z][A-Za-z]*\(const [A-Z][A-Za-z]*& other\)/ { say("A copy of its own.") }
/^  [A-Z][A-Za-z]*\([A-Z][A-Za-z]*&& other\)|operator=\([A-Z][A-Za-z]* other\)/ { say("Moves.") }
/ size\(\) const/ { say("How many there are.") }
/ empty\(\) const/ { say("Whether there is none.") }
/ void clear\(\)/ { say("Takes everything out.") }
/ bool contains\((KeyframeId|ClassId|Dynamics) [a-z]+\) const/ { say("Whether it is there.") }
/ (after|before)\(KeyframeId id\) const/ { say("The id next to this one, which need not be there; nothing at the end.") }
/^  using [A-Z][A-Za-z0-9]* = / { say("As used here.") }
/^  (double (mean|median|max)|std::size_t count) = / { say("Of the errors.") }
/EdgeList operator\(\)\(const std::vector</ { say("The edges of these nodes.") }
/(auto|Projection) operator\(\)\(const std::vector</ { say("Where these nodes lie.") }
/std::optional<double> operator\(\)\(const [A-Za-z]*& depth,/ { say("The depth of what is in the box, m.") }
/ descriptor\(const TopologyGraph/ { say("All that is compared of a graph.") }
/double similarity\(const / { say("The similarity of two graphs, from their descriptors.") }
/double operator\(\)\(const TopologyGraph/ { say("The similarity of two graphs.") }
/ static .* (box|label|confidence|depth)\(const / { say("See `detection_traits`.") }
/ static .* position\(const / { say("See `PositionTraits`.") }
/ (find|info)\(KeyframeId id\) const|> query\(const Graph&|void for_each\(const Visit&|MemoryUsage memory_usage\(\)/ {
  say("As the view does that the bag has now.")
}
/^[A-Z][A-Za-z0-9]*\(Projection\) ->/ { say("Takes the projection's type from the argument.") }

{ print }
# A template's head stands between the comment and the name.
!/^ *template </ { documented = /^ *\/\/\/[^<]/ }
